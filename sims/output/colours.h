// The colour of each triangle: what surgery made, or which component it belongs to.
#pragma once

#include "sims/output/picture.h"

namespace suture::sims {

/// Grey, blended towards a warm accent by the median freshness of a triangle's vertices: 1 as
/// surgery made them, 0 as they always were. \pre one freshness for each vertex
TriangleColours patch_colours(const Triangles& surface, const std::vector<double>& freshness);

/// A colour a connected component, from a palette that repeats.
TriangleColours component_colours(const Triangles& surface);

}  // namespace suture::sims
