// Points that are exactly equal, found in linear time.
#pragma once

#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// For each point, the index of the first one that equals it (−0 equals 0; NaN equals nothing).
std::vector<std::uint32_t> first_equal(const std::vector<Point>& points);

}  // namespace suture
