// The corners of a surface, bucketed by vertex: audit, measures and repair walk over them.
#pragma once

#include <span>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// One corner of a triangle, seen from its vertex v: the triangle is (v, next, prev).
struct Corner {
  std::uint32_t next, prev, triangle;
};

/// Whether the triangle has three different vertices, all below `vertices`.
inline bool usable(const Triangle& t, std::size_t vertices) {
  return t[0] < vertices && t[1] < vertices && t[2] < vertices && t[0] != t[1] && t[1] != t[2] &&
         t[2] != t[0];
}

/// The corners of all usable triangles, by vertex, in the order of the triangles. Making the lists
/// takes linear time.
class Corners {
 public:
  explicit Corners(const Triangles& surface) : first_(surface.positions.size() + 1, 0) {
    const std::size_t vertices = surface.positions.size();
    for (const Triangle& t : surface.triangles)
      if (usable(t, vertices))
        for (const std::uint32_t v : t) ++first_[v + 1];
    for (std::size_t v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
    corners_.resize(first_[vertices]);
    std::vector<std::size_t> at(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      const Triangle& t = surface.triangles[i];
      if (!usable(t, vertices)) continue;
      const auto id = static_cast<std::uint32_t>(i);
      corners_[at[t[0]]++] = {t[1], t[2], id};
      corners_[at[t[1]]++] = {t[2], t[0], id};
      corners_[at[t[2]]++] = {t[0], t[1], id};
    }
  }

  /// The corners at the vertex. \pre the surface has it
  std::span<const Corner> of(std::size_t vertex) const {
    return {corners_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }

  /// Calls f(triangle, whether it runs from a to b) for each use of the edge (a, b). The walk goes
  /// round the end with fewer triangles, so that all edges of a surface together take linear time
  /// even where one vertex has nearly all triangles. \pre the surface has both vertices
  template <class F>
  void for_each_use(std::uint32_t a, std::uint32_t b, F f) const {
    const bool at_a = of(a).size() <= of(b).size();
    const std::uint32_t v = at_a ? a : b, other = at_a ? b : a;
    for (const Corner& c : of(v)) {
      if (c.next == other) f(c.triangle, at_a);
      if (c.prev == other) f(c.triangle, !at_a);
    }
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<Corner> corners_;
};

}  // namespace suture
