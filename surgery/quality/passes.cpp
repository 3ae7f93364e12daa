// Lengths by curvature, and how an edge is split [§6.2; Dunyach et al. 2013].
#include "surgery/quality/passes.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>

namespace suture::surgery {

namespace {

/// The largest curvature of the circles that touch the surface at v and go through a neighbour. At
/// a fold that the mesh does not resolve it is about 2 / the edges' length, so that these get
/// shorter until they do.
double curvature(const Mesh& mesh, Mesh::Vertex_index v) {
  const Point n = vertex_normal(mesh, v), at = to_point(mesh.point(v));
  double most = 0;
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    const Point d = to_point(mesh.point(mesh.source(h))) - at;
    const double squared = d.squaredNorm();
    if (squared > 0) most = std::max(most, 2 * std::abs(n.dot(d)) / squared);
  }
  return most;
}

}  // namespace

void set_scales(Improvement& work) {
  const QualityOptions& q = work.options;
  // A chord of length L is L²κ/8 from its arc.
  const double flat = 8 * q.chord_error / (q.edge_length * q.edge_length);
  for (const auto v : work.mesh.vertices()) {
    const double asked = std::sqrt(flat / curvature(work.mesh, v));
    work.scales[v] = asked < 1 ? std::max(asked, q.finest) : 1;
  }
}

CollapseRules Improvement::rules_at(Mesh::Halfedge_index h) const {
  CollapseRules here = rules;
  if (options.chord_error > 0) {
    const double s = scale(h);
    here.volume_bound *= s * s * s;
    here.sliver_height *= s;
  }
  return here;
}

bool is_bad(const Shape& shape, const Improvement& improvement) {
  return shape.smallest_sine < improvement.sin_smallest_angle ||
         shape.largest_cosine < improvement.cos_largest_angle;
}

Mesh::Vertex_index split_edge(Mesh& mesh, Mesh::Halfedge_index h, const Point& at) {
  const auto half = CGAL::Euler::split_edge(h, mesh);  // ends at the new vertex; h leaves it
  const auto v = mesh.target(half);
  mesh.point(v) = to_cgal(at);
  CGAL::Euler::split_face(half, mesh.next(h), mesh);
  CGAL::Euler::split_face(mesh.opposite(h), mesh.next(mesh.opposite(half)), mesh);
  return v;
}

LocalChange split_change(const Mesh& mesh, Mesh::Halfedge_index h, const Point& at) {
  LocalChange change;
  for (const auto g : {h, mesh.opposite(h)}) {
    const Point a = to_point(mesh.point(mesh.source(g))), b = to_point(mesh.point(mesh.target(g)));
    const Point c = to_point(mesh.point(mesh.target(mesh.next(g))));
    change.triangles.push_back({{a, b, c}, {a, at, c}});
    change.triangles.push_back({{a, b, c}, {at, b, c}});
    change.swept.push_back({a, b, c, at});
  }
  return change;
}

}  // namespace suture::surgery
