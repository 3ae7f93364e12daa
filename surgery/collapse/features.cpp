// Sharp edges from the angle between normals; slivers do not count [§6.2].
#include "surgery/collapse/features.h"

namespace suture::surgery {

namespace {

Mesh::Halfedge_index longest_edge(const Mesh& mesh, Mesh::Face_index f) {
  auto best = mesh.halfedge(f);
  double longest = -1;
  for (const auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
    const double length =
        CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    if (length > longest) {
      longest = length;
      best = h;
    }
  }
  return best;
}

/// The unit normal, or zero for a sliver.
Point own_normal(const Mesh& mesh, Mesh::Face_index f, double sliver_height) {
  const Corners t = corners(mesh, f);
  const Point n = area_vector(t);
  const double size = n.norm();
  return height(t, size) > sliver_height ? Point(n / size) : Point(Point::Zero());
}

}  // namespace

Corners corners(const Mesh& mesh, Mesh::Face_index f) {
  const auto h = mesh.halfedge(f);
  return {to_point(mesh.point(mesh.source(h))), to_point(mesh.point(mesh.target(h))),
          to_point(mesh.point(mesh.target(mesh.next(h))))};
}

Point reliable_normal(const Mesh& mesh, Mesh::Face_index f, double sliver_height) {
  const Point n = own_normal(mesh, f, sliver_height);
  if (!n.isZero(0)) return n;
  return own_normal(mesh, mesh.face(mesh.opposite(longest_edge(mesh, f))), sliver_height);
}

bool is_feature(const Mesh& mesh, Mesh::Edge_index e, const CollapseRules& rules) {
  if (rules.cos_feature < -1) return false;
  const auto h = mesh.halfedge(e);
  const Point a = reliable_normal(mesh, mesh.face(h), rules.sliver_height);
  const Point b = reliable_normal(mesh, mesh.face(mesh.opposite(h)), rules.sliver_height);
  return !a.isZero(0) && !b.isZero(0) && a.dot(b) < rules.cos_feature;
}

VertexKind vertex_kind(const Mesh& mesh, Mesh::Vertex_index v, const CollapseRules& rules) {
  if (rules.cos_feature < -1) return VertexKind::free;
  int count = 0;
  std::array<Point, 2> along;
  const Point at = to_point(mesh.point(v));
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
    if (is_feature(mesh, mesh.edge(h), rules)) {
      if (count == 2) return VertexKind::corner;
      along[static_cast<std::size_t>(count++)] = to_point(mesh.point(mesh.source(h))) - at;
    }
  if (count == 0) return VertexKind::free;
  if (count == 1) return VertexKind::corner;
  const bool straight =
      -along[0].dot(along[1]) > rules.cos_feature * along[0].norm() * along[1].norm();
  return straight ? VertexKind::crease : VertexKind::corner;
}

bool leaves_feature(const Mesh& mesh, Mesh::Halfedge_index h, const CollapseRules& rules) {
  const VertexKind kind = vertex_kind(mesh, mesh.source(h), rules);
  if (kind == VertexKind::free) return false;
  return kind == VertexKind::corner || !is_feature(mesh, mesh.edge(h), rules);
}

}  // namespace suture::surgery
