// Normals, lattice nodes and volume of one local operation [§6.2].
#include "surgery/collapse/local_change.h"

#include <algorithm>
#include <cmath>

namespace suture::surgery {

namespace {

/// Area vectors of the star added up: which way it faces, whatever its slivers say.
Point facing(const LocalChange& change) {
  Point sum = Point::Zero();
  for (const auto& t : change.triangles) sum += area_vector(t.before);
  return sum;
}

bool turns_too_far(const LocalChange& change, const CollapseRules& rules) {
  const Point mean = facing(change);
  for (const auto& t : change.triangles) {
    const Point was = area_vector(t.before), is = area_vector(t.after);
    const double was_size = was.norm(), is_size = is.norm();
    if (height(t.before, was_size) > rules.sliver_height) {
      const double agreement = was.dot(is);
      if (!(agreement > 0) || agreement < rules.cos_turn * was_size * is_size) return true;
    } else if (height(t.after, is_size) > rules.sliver_height && mean.dot(is) < 0) {
      return true;
    }
  }
  return false;
}

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

bool sweeps_any_node(const LocalChange& change, const Lattice& lattice, const Oracle& oracle) {
  if (change.swept.empty()) return false;
  Point low = change.swept.front()[0], high = low;
  for (const auto& tetrahedron : change.swept)
    for (const Point& p : tetrahedron) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  if (nodes_between(low, high, lattice).empty()) return false;
  return std::any_of(change.swept.begin(), change.swept.end(), [&](const auto& t) {
    return holds_node(t[0], t[1], t[2], t[3], lattice, oracle);
  });
}

bool around(const Mesh& mesh, Mesh::Halfedge_index h, const Mesh::Halfedge_index removed) {
  return mesh.face(h) == mesh.face(removed) || mesh.face(h) == mesh.face(mesh.opposite(removed));
}

}  // namespace

double height(const Corners& t, double doubled_area) {
  const double longest = std::max(
      {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
  return longest > 0 ? doubled_area / std::sqrt(longest) : 0;
}

double volume_moved(const LocalChange& change) {
  double sum = 0;
  for (const auto& t : change.swept)
    sum += std::abs((t[1] - t[0]).dot((t[2] - t[0]).cross(t[3] - t[0])));
  return sum / 6;
}

Refusal judge(const LocalChange& change, const CollapseRules& rules) {
  if (turns_too_far(change, rules)) return Refusal::normal;
  if (rules.lattice && sweeps_any_node(change, *rules.lattice, *rules.oracle)) return Refusal::node;
  if (volume_moved(change) > rules.volume_bound) return Refusal::volume;
  return Refusal::none;
}

void count_refusal(CollapseCounts& counts, Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      break;
    case Refusal::link:
      ++counts.refused_link;
      break;
    case Refusal::normal:
      ++counts.refused_normal;
      break;
    case Refusal::node:
      ++counts.refused_node;
      break;
    case Refusal::volume:
      ++counts.refused_volume;
      break;
    case Refusal::feature:
      ++counts.refused_feature;
      break;
    case Refusal::premature:
      ++counts.delayed;
      break;
  }
}

void add_to(CollapseCounts& sum, const CollapseCounts& counts) {
  sum.done += counts.done;
  sum.delayed += counts.delayed;
  sum.blocked += counts.blocked;
  sum.refused_link += counts.refused_link;
  sum.refused_normal += counts.refused_normal;
  sum.refused_node += counts.refused_node;
  sum.refused_volume += counts.refused_volume;
  sum.refused_feature += counts.refused_feature;
}

LocalChange collapse_change(const Mesh& mesh, Mesh::Halfedge_index h, const Point& to,
                            const FaceMarks* doomed) {
  LocalChange change;
  const auto add_star = [&](Mesh::Vertex_index v, bool first) {
    const Point from = to_point(mesh.point(v));
    if (from == to) return;
    for (const auto g : mesh.halfedges_around_target(mesh.halfedge(v))) {
      if (doomed && (*doomed)[mesh.face(g)] != 0) continue;
      const bool goes = around(mesh, g, h);
      if (goes && !first) continue;
      const Point a = to_point(mesh.point(mesh.target(mesh.next(g))));
      const Point b = to_point(mesh.point(mesh.source(g)));
      if (!goes) change.triangles.push_back({{from, a, b}, {to, a, b}});
      if (a != to && b != to) change.swept.push_back({from, to, a, b});
    }
  };
  add_star(mesh.source(h), true);
  add_star(mesh.target(h), false);  // the triangles that go have no extent left by then
  return change;
}

namespace {

/// Without a walk round the whole star: a vertex may have any number of triangles.
bool has_three_or_fewer(const Mesh& mesh, Mesh::Vertex_index v) {
  const auto first = mesh.halfedge(v);
  auto h = first;
  for (int i = 0; i < 3; ++i)
    if ((h = mesh.next_around_target(h)) == first) return true;
  return false;
}

/// No vertex but those across from `h` is a neighbour of both its ends. CGAL's own test walks the
/// stars of all neighbours too, which takes the square of the valence round a vertex of a great
/// one.
bool satisfies_link_condition(const Mesh& mesh, Mesh::Halfedge_index h) {
  boost::container::small_vector<Mesh::Vertex_index, 24> around;
  for (const auto g : mesh.halfedges_around_target(mesh.opposite(h)))
    around.push_back(mesh.source(g));
  std::sort(around.begin(), around.end());
  const auto left = mesh.target(mesh.next(h));
  const auto right = mesh.target(mesh.next(mesh.opposite(h)));
  for (const auto g : mesh.halfedges_around_target(h)) {
    const auto v = mesh.source(g);
    if (v != left && v != right && std::binary_search(around.begin(), around.end(), v))
      return false;
  }
  return true;
}

}  // namespace

bool keeps_manifold(const Mesh& mesh, Mesh::Halfedge_index h) {
  const auto left = mesh.target(mesh.next(h));
  const auto right = mesh.target(mesh.next(mesh.opposite(h)));
  if (left == right || has_three_or_fewer(mesh, left) || has_three_or_fewer(mesh, right))
    return false;
  return satisfies_link_condition(mesh, h);
}

namespace {

/// Bounds of the nodes of one lattice row that a half-space can hold, in plain doubles with a
/// margin: what they leave out is outside for certain, what they keep is for the oracle.
struct HalfSpace {
  Point normal, at;
  double noise;  // of the normal's components

  /// \param unit a power of two that brings the differences near 1, so that neither their products
  /// nor a quotient leaves the doubles at any scale of the mesh
  HalfSpace(const Point& a, const Point& b, const Point& c, int side, double unit) : at(a) {
    constexpr double kRounding = 0x1p-48;  // a few bits of the products in the cross product
    constexpr double kUnderflow = 0x1p-1060;
    const Point s = (b - a) * unit, t = (c - a) * unit;
    normal = s.cross(t) * side;
    noise = kRounding * s.lpNorm<1>() * t.lpNorm<1>() + kUnderflow;
  }
  void bound(const Point& row, int axis, double extent, double& low, double& high) const {
    const double slope = normal[axis];
    constexpr double kTrusted = 0x1p10;  // below it the slope is mostly noise, and says nothing
    if (!(std::abs(slope) > kTrusted * noise)) return;
    const Point tilt = normal / slope;
    Point across = row - at;
    across[axis] = 0;
    const double x = at[axis] - tilt.dot(across);
    const double margin =
        4 * extent * (noise / std::abs(slope)) * (1 + tilt.lpNorm<1>()) + 0x1p-40 * extent;
    if (slope > 0)
      low = std::max(low, x - margin);
    else
      high = std::min(high, x + margin);
  }
};

/// A power of two that brings a length near 1. \pre positive
double unit_of(double length) {
  return std::isfinite(length) ? std::ldexp(1.0, std::clamp(-std::ilogb(length), -1000, 1000)) : 1;
}

}  // namespace

bool holds_node(const Point& a, const Point& b, const Point& c, const Point& d,
                const Lattice& lattice, const Oracle& oracle) {
  const Point low = a.cwiseMin(b).cwiseMin(c).cwiseMin(d);
  const Point high = a.cwiseMax(b).cwiseMax(c).cwiseMax(d);
  const NodeRange range = nodes_between(low, high, lattice);
  if (range.empty()) return false;
  const int sign = oracle.orientation(a, b, c, d);
  if (sign == 0) return false;  // a surface that stays in one plane passes no shifted node
  auto holds = [&](const Point& node) {
    return oracle.triangle_side(a, b, c, node) == sign &&
           oracle.triangle_side(a, c, d, node) == sign &&
           oracle.triangle_side(a, d, b, node) == sign &&
           oracle.triangle_side(b, d, c, node) == sign;
  };
  int along = 0;  // rows run along the axis with the most nodes
  for (int axis = 1; axis < 3; ++axis)
    if (range.last[axis] - range.first[axis] > range.last[along] - range.first[along]) along = axis;
  const int u = next_axis(along), v = prev_axis(along);
  const double extent = (high - low).lpNorm<1>();
  const double unit = unit_of(extent);
  const std::array<HalfSpace, 4> faces = {
      HalfSpace(a, b, c, sign, unit), HalfSpace(a, c, d, sign, unit),
      HalfSpace(a, d, b, sign, unit), HalfSpace(b, d, c, sign, unit)};
  Index3 at;
  for (at[u] = range.first[u]; at[u] <= range.last[u]; ++at[u])
    for (at[v] = range.first[v]; at[v] <= range.last[v]; ++at[v]) {
      double from = low[along], to = high[along];
      at[along] = range.first[along];
      for (const HalfSpace& face : faces) face.bound(lattice.node(at), along, extent, from, to);
      if (from > to) continue;
      const int last = std::min(range.last[along], lattice.cell_of(along, to) + 1);
      at[along] = std::max(range.first[along], lattice.cell_of(along, from));
      for (; at[along] <= last; ++at[along])
        if (holds(lattice.node(at))) return true;
    }
  return false;
}

}  // namespace suture::surgery
