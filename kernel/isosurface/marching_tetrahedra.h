// Marching tetrahedra, cube by cube, on values at nodes: closed, manifold, embedded [Kuhn 1960].
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "kernel/lattice.h"
#include "kernel/sparse_field.h"
#include "kernel/triangles.h"

namespace suture {

/// A node of the grid as a cube's corner.
struct CubeCorner {
  Index3 node{};
  std::uint64_t id = 0;  ///< one number for each node, below 2⁶¹
  double value = 0;      ///< negative inside; 0 counts as outside
};

/// The node at corner c of a cube, which is (c & 1, c >> 1 & 1, c >> 2) from the lowest one.
inline Index3 cube_corner(const Index3& cube, int c) {
  return {cube[0] + (c & 1), cube[1] + (c >> 1 & 1), cube[2] + (c >> 2)};
}

/// Puts the surface together from cubes that come in any order, each once, and cuts each into six
/// tetrahedra. Where all cubes come whose corners are not on one side, the surface is closed.
class MarchingTetrahedra {
 public:
  /// Gives the point where the surface crosses the edge between two nodes, one inside and one not,
  /// off both ends. It is asked once for each edge, with the lower node first.
  using Place = std::function<Point(const CubeCorner& from, const CubeCorner& to)>;

  explicit MarchingTetrahedra(Place place) : place_(std::move(place)) {}
  /// Adds the pieces in one cube. \pre the corners are in the order of cube_corner
  void add_cube(const std::array<CubeCorner, 8>& corners);
  /// Hands the surface over.
  Triangles take() { return std::move(surface_); }

 private:
  using Corners = std::array<CubeCorner, 8>;
  void add_tetrahedron(const Corners& corners, std::array<int, 4> t);
  std::uint32_t vertex(const Corners& corners, int a, int b);

  Place place_;
  SparseField<char> at_;  ///< its k-th key names the edge of vertex k
  Triangles surface_;
};

/// The zero of a linear function with the values `from` and `to` at two nodes, as a part of the way
/// between them, from off_ends to 1 − off_ends. \pre the two values have opposite signs
double linear_zero(double from, double to, double off_ends);

}  // namespace suture
