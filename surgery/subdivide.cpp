// Long edges are split, the longest first [§6.2].
#include <algorithm>
#include <optional>
#include <queue>
#include <tuple>

#include "surgery/quality_passes.h"

namespace suture {

namespace {

struct LongEdge {
  double length;
  Mesh::Edge_index edge;
  bool operator<(const LongEdge& b) const {
    return std::tie(length, b.edge) < std::tie(b.length, edge);
  }
};

/// Weighted so that it is exact on a sphere, however irregular the star [Max 1999].
Point vertex_normal(const Mesh& mesh, Mesh::Vertex_index v) {
  Point sum = Point::Zero();
  const Point at = to_point(mesh.point(v));
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    const Point a = to_point(mesh.point(mesh.target(mesh.next(h)))) - at;
    const Point b = to_point(mesh.point(mesh.source(h))) - at;
    const double weight = a.squaredNorm() * b.squaredNorm();
    if (weight > 0) sum += a.cross(b) / weight;
  }
  return sum.normalized();
}

Point midpoint(const Mesh& mesh, Mesh::Halfedge_index h) {
  return (to_point(mesh.point(mesh.source(h))) + to_point(mesh.point(mesh.target(h)))) / 2;
}

}  // namespace

Point curved_point(const Improvement& work, Mesh::Halfedge_index h) {
  const Mesh& mesh = work.mesh;
  const Point middle = midpoint(mesh, h);
  if (vertex_kind(mesh, mesh.source(h), work.rules) != VertexKind::free ||
      vertex_kind(mesh, mesh.target(h), work.rules) != VertexKind::free)
    return middle;
  const Point along = to_point(mesh.point(mesh.target(h))) - to_point(mesh.point(mesh.source(h)));
  const Point at_source = vertex_normal(mesh, mesh.source(h));
  const Point at_target = vertex_normal(mesh, mesh.target(h));
  return middle - (along.dot(at_source) * at_source - along.dot(at_target) * at_target) / 8;
}

namespace {

/// The edges that a split makes are short enough, or at most this part of the edge that is split. A
/// split of a triangle's longest edge near its middle gives at most 0.87 of it. Where a longer edge
/// may not be split, triangles on it could be split for ever towards a third of it.
constexpr double kShrinks = 0.95;

/// Where to split: the point asked for if the rules allow it, else the middle, else off the middle,
/// where rounding may not push a lattice node through the surface.
std::optional<Point> choose_point(const Improvement& work, Mesh::Halfedge_index h) {
  const Mesh& mesh = work.mesh;
  const Point a = to_point(mesh.point(mesh.source(h)));
  const Point b = to_point(mesh.point(mesh.target(h)));
  const Point c = to_point(mesh.point(mesh.target(mesh.next(h))));
  const Point d = to_point(mesh.point(mesh.target(mesh.next(mesh.opposite(h)))));
  const double most = std::max(work.longest, kShrinks * (b - a).norm());
  const Point middle = midpoint(mesh, h);
  const Point first =
      work.options.subdivision == Subdivision::curved ? curved_point(work, h) : middle;
  for (const Point& p :
       {first, middle, Point(0.4375 * a + 0.5625 * b), Point(0.5625 * a + 0.4375 * b)}) {
    const double longest =
        std::max({(p - a).norm(), (p - b).norm(), (p - c).norm(), (p - d).norm()});
    if (longest <= most && judge(split_change(mesh, h, p), work.rules) == Refusal::none) return p;
  }
  return std::nullopt;
}

}  // namespace

std::size_t subdivide_long_edges(Improvement& work) {
  Mesh& mesh = work.mesh;
  std::priority_queue<LongEdge> queue;
  const auto push_if_long = [&](Mesh::Halfedge_index h) {
    const double length = length_of(mesh, h);
    if (length > work.longest) queue.push({length, mesh.edge(h)});
  };
  for (const auto e : mesh.edges()) push_if_long(mesh.halfedge(e));
  std::size_t done = 0;
  while (!queue.empty()) {
    const LongEdge next = queue.top();
    queue.pop();
    const auto h = mesh.halfedge(next.edge);
    if (length_of(mesh, h) != next.length) continue;
    const std::optional<Point> at = choose_point(work, h);
    if (!at) continue;
    const auto v = split_edge(mesh, h, *at);
    ++done;
    for (const auto g : mesh.halfedges_around_target(mesh.halfedge(v))) push_if_long(g);
  }
  work.report.subdivisions += done;
  return done;
}

}  // namespace suture
