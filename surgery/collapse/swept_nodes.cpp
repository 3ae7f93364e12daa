// Each row of nodes is cut down to the tetrahedron in plain doubles, and the oracle decides [§6.2].
#include "surgery/collapse/swept_nodes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::surgery {

namespace {

struct NodeRange {
  Index3 first, last;  ///< both included; empty where first > last on some axis
  bool empty() const { return first[0] > last[0] || first[1] > last[1] || first[2] > last[2]; }
};

/// Nodes of the shifted lattice between two corners of a box: low <= plane < high on each axis.
NodeRange nodes_between(const Point& low, const Point& high, const Lattice& lattice) {
  NodeRange range{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    range.first[a] = lattice.cell_of(axis, low[axis]) + 1;
    range.last[a] = lattice.cell_of(axis, high[axis]);
    if (range.first[a] > range.last[a]) break;
  }
  return range;
}

/// A row of lattice nodes along `axis` through `through`, from `low` to `high`. All lie within
/// `extent` of each other.
struct NodeRow {
  Point through;
  int axis;
  double extent;
  double low, high;
};

/// A half-space that bounds a row to the nodes that it can hold, in plain doubles with a margin:
/// those that it leaves out are outside for certain, and the others are for the oracle.
struct HalfSpace {
  Point normal, at;
  double noise;  // of the normal's components

  /// \param unit a power of two that brings the differences near 1, so that neither their products
  /// nor a quotient leaves the doubles at any scale of the mesh
  HalfSpace(const Corners& face, int side, double unit) : at(face[0]) {
    constexpr double kRounding = 0x1p-48;  // a few bits of the products in the cross product
    constexpr double kUnderflow = 0x1p-1060;
    const Point s = (face[1] - face[0]) * unit, t = (face[2] - face[0]) * unit;
    normal = s.cross(t) * side;
    noise = kRounding * s.lpNorm<1>() * t.lpNorm<1>() + kUnderflow;
  }
  void bound(NodeRow& row) const {
    const int axis = row.axis;
    const double extent = row.extent, slope = normal[axis];
    constexpr double kTrusted = 0x1p10;  // below it the slope is mostly noise, and says nothing
    if (!(std::abs(slope) > kTrusted * noise)) return;
    const Point tilt = normal / slope;
    Point across = row.through - at;
    across[axis] = 0;
    const double x = at[axis] - tilt.dot(across);
    const double margin =
        4 * extent * (noise / std::abs(slope)) * (1 + tilt.lpNorm<1>()) + 0x1p-40 * extent;
    if (slope > 0)
      row.low = std::max(row.low, x - margin);
    else
      row.high = std::min(row.high, x + margin);
  }
};

/// A power of two that brings a length near 1. \pre positive
double unit_of(double length) {
  return std::isfinite(length) ? std::ldexp(1.0, std::clamp(-std::ilogb(length), -1000, 1000)) : 1;
}

}  // namespace

bool holds_node(const Tetrahedron& tetrahedron, const ShiftedLattice& on) {
  const auto& [a, b, c, d] = tetrahedron;
  const Point low = a.cwiseMin(b).cwiseMin(c).cwiseMin(d);
  const Point high = a.cwiseMax(b).cwiseMax(c).cwiseMax(d);
  const Lattice& lattice = on.lattice;
  const NodeRange range = nodes_between(low, high, lattice);
  if (range.empty()) return false;
  const int sign = on.oracle.orientation(a, b, c, d);
  if (sign == 0) return false;  // a surface that stays in one plane passes no shifted node
  const std::array<Corners, 4> corners = {{{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}}};
  auto holds = [&](const Point& node) {
    return std::all_of(corners.begin(), corners.end(), [&](const Corners& f) {
      return on.oracle.triangle_side(f[0], f[1], f[2], node) == sign;
    });
  };
  int along = 0;  // rows run along the axis with the most nodes
  for (int axis = 1; axis < 3; ++axis)
    if (range.last[axis] - range.first[axis] > range.last[along] - range.first[along]) along = axis;
  const int u = next_axis(along), v = prev_axis(along);
  const double extent = (high - low).lpNorm<1>();
  const double unit = unit_of(extent);
  const std::array<HalfSpace, 4> faces = {
      HalfSpace(corners[0], sign, unit), HalfSpace(corners[1], sign, unit),
      HalfSpace(corners[2], sign, unit), HalfSpace(corners[3], sign, unit)};
  Index3 at;
  for (at[u] = range.first[u]; at[u] <= range.last[u]; ++at[u])
    for (at[v] = range.first[v]; at[v] <= range.last[v]; ++at[v]) {
      at[along] = range.first[along];
      NodeRow row{lattice.node(at), along, extent, low[along], high[along]};
      for (const HalfSpace& face : faces) face.bound(row);
      if (row.low > row.high) continue;
      const int last = std::min(range.last[along], lattice.cell_of(along, row.high) + 1);
      at[along] = std::max(range.first[along], lattice.cell_of(along, row.low));
      for (; at[along] <= last; ++at[along])
        if (holds(lattice.node(at))) return true;
    }
  return false;
}

bool any_holds_node(std::span<const Tetrahedron> tetrahedra, const ShiftedLattice& on) {
  if (tetrahedra.empty()) return false;
  Point low = tetrahedra.front()[0], high = low;
  for (const Tetrahedron& t : tetrahedra)
    for (const Point& p : t) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  if (nodes_between(low, high, on.lattice).empty()) return false;
  return std::any_of(tetrahedra.begin(), tetrahedra.end(),
                     [&](const Tetrahedron& t) { return holds_node(t, on); });
}

}  // namespace suture::surgery
