// The colour of each triangle: what surgery made, or which component it belongs to.
#pragma once

#include "sims/output/picture.h"

namespace suture {

/// Grey, blended towards a warm accent by how fresh the least fresh of a triangle's vertices is: 1
/// as surgery made it, 0 as it always was. \pre one freshness for each vertex
TriangleColours patch_colours(const Triangles& surface, const std::vector<double>& freshness);

/// A colour a connected component, from a palette that repeats.
TriangleColours component_colours(const Triangles& surface);

}  // namespace suture
