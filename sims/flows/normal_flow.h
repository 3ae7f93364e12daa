// Normal flow: every vertex moves along its own normal.
#pragma once

#include "kernel/triangles.h"

namespace suture::sims {

/// Area-weighted unit normal of each vertex; zero where its triangles have no area together.
std::vector<Point> vertex_normals(const Triangles& surface);

/// Positions moved outwards by `distance` (inwards where it is negative) along vertex_normals.
std::vector<Point> normal_flow(const Triangles& surface, double distance);

}  // namespace suture::sims
