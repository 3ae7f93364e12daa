// Which triangles of a surface pass through one another, decided exactly.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

struct SelfIntersections {
  /// The pairs of triangles that intersect, lower index first, in increasing order.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  /// How many triangles have no area, as their vertices lie on one line. The pairs leave them out.
  std::size_t without_area = 0;
  /// Whether there are more pairs than were asked for. Which of them are listed is then left open.
  bool capped = false;
};

struct SelfIntersectionOptions {
  /// The number of pairs after which the search ends: n copies of one body have about n² pairs for
  /// each triangle.
  std::size_t most = std::numeric_limits<std::size_t>::max();
};

/// Finds the pairs of triangles that have more in common than the vertices and edges that they
/// share by index. Triangles folded flat onto each other are such a pair, and so are unconnected
/// ones that only touch. Any surface will do, closed or not. \pre finite positions, indices in
/// range
SelfIntersections self_intersections(const Triangles& surface,
                                     const SelfIntersectionOptions& options = {});

}  // namespace suture
