// Distances to a surface at all nodes of a box, cut off at a width: quick to sample, simple to
// move.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"

namespace suture::sims {

/// The grid's nodes low … low + size − 1, in the order of (i, j, k).
struct NodeBox {
  Index3 low{0, 0, 0};
  Index3 size{0, 0, 0};

  std::size_t count() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
           static_cast<std::size_t>(size[2]);
  }
  std::size_t stride(int axis) const {
    const auto z = static_cast<std::size_t>(size[2]);
    return axis == 2 ? 1 : axis == 1 ? z : z * static_cast<std::size_t>(size[1]);
  }
  /// \pre the node lies in the box
  std::size_t at(const Index3& node) const {
    return static_cast<std::size_t>(node[0] - low[0]) * stride(0) +
           static_cast<std::size_t>(node[1] - low[1]) * stride(1) +
           static_cast<std::size_t>(node[2] - low[2]);
  }
  Index3 node(std::size_t at) const;
};

/// The nodes from floor(low) − margin to ceil(high) + margin, in cells.
/// \throw InvalidInput if they are more than 2²⁸, or their indices would not fit
NodeBox node_box(const Box& cells, int margin);

/// Points are in cells from the grid's origin, and so are distances; negative is inside. On the
/// box's border all is outside, and beyond it too.
struct DenseLevelSet {
  NodeBox box;
  std::vector<double> phi;  ///< at each node, within ± width
  double width = 0;

  /// Trilinear.
  double sample(const Point& p) const {
    const double x = p[0] - box.low[0], y = p[1] - box.low[1], z = p[2] - box.low[2];
    if (!(x >= 0 && y >= 0 && z >= 0 && x < box.size[0] - 1 && y < box.size[1] - 1 &&
          z < box.size[2] - 1))
      return width;
    const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
    const std::size_t sx = box.stride(0), sy = box.stride(1);
    const double* at = phi.data() + static_cast<std::size_t>(i) * sx +
                       static_cast<std::size_t>(j) * sy + static_cast<std::size_t>(k);
    const double fx = x - i, fy = y - j, fz = z - k;
    const auto along = [&](const double* a) { return a[0] + fz * (a[1] - a[0]); };
    const auto across = [&](const double* a) {
      const double low = along(a);
      return low + fy * (along(a + sy) - low);
    };
    const double low = across(at);
    return low + fx * (across(at + sx) - low);
  }

  /// Direction in which φ grows, by central differences over a cell to each side; 0 where it does
  /// not.
  Point normal(const Point& p) const;
};

/// Nodes with a neighbour along an axis on the other side, in order. A node with φ = 0 is outside.
std::vector<std::size_t> interface_nodes(const DenseLevelSet& set);

}  // namespace suture::sims
