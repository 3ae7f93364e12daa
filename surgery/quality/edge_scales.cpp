// Shorter edges where the surface is curved [§6.2; Dunyach et al. 2013].
#include <algorithm>
#include <cmath>

#include "surgery/quality/passes.h"
#include "surgery/quality/vertex_normal.h"

namespace suture::surgery {

namespace {

/// The largest curvature of the circles that touch the surface at v and go through a neighbour. Of
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

}  // namespace suture::surgery
