// Polygons with more than three corners, cut into triangles.
#pragma once

#include <span>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// Appends triangles that cover the polygon whose corners are those indices of `positions`. They
/// are the fan round the first corner where none of it is turned over; else they are ears, cut off
/// one by one in the projection along the polygon's normal. \pre three corners or more, all in
/// range
void triangulate_polygon(const std::vector<Point>& positions, std::span<const std::int64_t> corners,
                         std::vector<Triangle>& triangles);

}  // namespace suture
