// Which way triangles face: consistently within a component, and outwards as a whole.
#pragma once

#include "kernel/triangles.h"

namespace suture {

struct TurnedTriangles {
  std::size_t triangles = 0;       ///< turned over
  std::size_t not_orientable = 0;  ///< components, such as a Klein bottle, left as they were
};

/// Turns triangles so that two that share an edge run along it in opposite ways, wherever exactly
/// two share it. In each component the fewer are turned; of equally many, not its first triangle.
/// Safe on any indices.
TurnedTriangles orient_consistently(Triangles& surface);

/// The first triangle of each closed component that is inside-out, in increasing order. From the
/// outside in: a component of negative volume is inside-out where it lies in no material, that is,
/// where the winding number round it is below 1 (in material it is a cavity); one of positive
/// volume is where the component straight round it is inside-out and the winding is then 1 (it was
/// that one's cavity). A component lies in another if its box and its six extreme vertices do;
/// signs of volumes and sides are exact. Components that are not closed and oriented are passed
/// over. \pre finite positions, indices in range
std::vector<std::uint32_t> inside_out_components(const Triangles& surface);

/// Turns each component over that holds one of `triangles`.
void turn_components(Triangles& surface, const std::vector<std::uint32_t>& triangles);

}  // namespace suture
