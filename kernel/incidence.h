// A flat copy of a closed mesh's incidence, free of CGAL: what crossings, cut and fill read.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// Vertices, edges and triangles of a closed manifold by index, each edge once.
struct Incidence {
  std::vector<Point> positions;
  std::vector<Triangle> triangles;
  std::vector<std::array<std::uint32_t, 3>> triangle_edges;  ///< edge k joins corners k and k+1
  std::vector<std::array<std::uint32_t, 2>> edges;           ///< end points, lower index first
  std::vector<std::array<std::uint32_t, 2>> edge_triangles;  ///< the two triangles at it
};

/// What is asked of edges: two triangles at each, or any number (edge_triangles then stays empty).
enum class EdgeUse { manifold, any };

/// Edges are numbered in the order in which triangles meet them. Vertex and triangle indices stay.
/// \throw InternalFailure if `use` is manifold and an edge has not exactly two triangles
Incidence incidence(const Triangles& surface, EdgeUse use = EdgeUse::manifold);

}  // namespace suture
