// Normals for drawing: smooth across gentle edges, sharp across features, calm over slivers.
#pragma once

#include <array>

#include "kernel/triangles.h"

namespace suture::sims {

/// A unit normal for each corner of each triangle: the sum, by area, of the normals round its
/// vertex that turn from the triangle's own by less than `feature_angle` degrees. Triangles that
/// are nearly without area have no direction of their own and take the mean of all.
std::vector<std::array<Point, 3>> corner_normals(const Triangles& surface, double feature_angle);

}  // namespace suture::sims
