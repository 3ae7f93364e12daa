// Which triangles of a surface pass through one another, decided exactly.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

struct SelfIntersections {
  /// Pairs of triangles, lower index first, in increasing order.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  /// Triangles whose vertices lie on one line: without area, and left out of the pairs.
  std::size_t without_area = 0;
  /// There are more pairs than were asked for; which of them are listed is then left open.
  bool capped = false;
};

struct SelfIntersectionOptions {
  /// Pairs after which the search ends: n copies of one body have about n² pairs for each triangle.
  std::size_t most = std::numeric_limits<std::size_t>::max();
};

/// Two triangles intersect if they have more in common than the vertices and edges that they share
/// by index: so triangles folded flat onto each other do, and so do unconnected ones that only
/// touch. Any surface will do, closed or not. \pre finite positions, indices in range
SelfIntersections self_intersections(const Triangles& surface,
                                     const SelfIntersectionOptions& options = {});

}  // namespace suture
