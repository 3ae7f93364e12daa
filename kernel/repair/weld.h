// Points that are exactly equal, found in linear time.
#pragma once

#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// The index of the first point that equals it, for each point. −0 equals 0, and NaN equals
/// nothing.
std::vector<std::uint32_t> first_equal(const std::vector<Point>& points);

}  // namespace suture
