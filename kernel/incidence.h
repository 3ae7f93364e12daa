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

/// Edges are numbered in the order in which triangles meet them. Vertex and triangle indices stay.
/// \pre every edge has exactly two triangles \throw InternalFailure if one has not
Incidence incidence(const Triangles& surface);

}  // namespace suture
