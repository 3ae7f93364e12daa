// Closed components that enclose their material from the wrong side.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// The first triangle of each closed component that is inside-out, in increasing order. Components
/// are judged from the outside in. One of negative volume is inside-out where the winding number
/// round it is below 1, that is, where it lies in no material (in material it is a cavity). One of
/// positive volume is where the component straight round it is inside-out and the winding is then
/// 1: it was a cavity of that one. A component lies in another if its box and its six extreme
/// vertices do; signs of volumes and sides are exact. Components that are not closed and oriented
/// are passed over. \pre finite positions, indices in range
std::vector<std::uint32_t> inside_out_components(const Triangles& surface);

/// Turns each component over that holds one of `triangles`. \pre indices in range
void turn_components(Triangles& surface, const std::vector<std::uint32_t>& triangles);

}  // namespace suture
