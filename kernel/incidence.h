// A flat copy of a surface's incidence, free of CGAL: crossings, cut and fill read it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// The vertices, edges and triangles of a surface by index, each edge once.
struct Incidence {
  std::vector<Point> positions;
  std::vector<Triangle> triangles;
  std::vector<std::array<std::uint32_t, 3>> triangle_edges;  ///< edge k joins corners k and k+1
  std::vector<std::array<std::uint32_t, 2>> edges;           ///< end points, lower index first
  std::vector<std::array<std::uint32_t, 2>> edge_triangles;  ///< the two triangles at it
};

/// How many triangles may be at an edge: just two, or any number. With `any`, edge_triangles stays
/// empty.
enum class EdgeUse { manifold, any };

/// Numbers the edges in the order in which triangles meet them; vertices and triangles keep their
/// indices. \pre all indices are in range
/// \throw InternalFailure if `use` is manifold and an edge has not exactly two triangles
Incidence incidence(const Triangles& surface, EdgeUse use = EdgeUse::manifold);

}  // namespace suture
