// The order in which the rules are asked, and the three steps of a collapse [§6.1 step 3, §6.2].
#include "surgery/collapse/edge_collapse.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include "surgery/collapse/features.h"

namespace suture::surgery {

Refusal may_collapse_to(const Mesh& mesh, const EdgeCollapse& collapse,
                        const CollapseRules& rules) {
  const auto& [h, to] = collapse;
  if (!to.allFinite()) return Refusal::normal;
  if (!keeps_manifold(mesh, h)) return Refusal::link;
  const Refusal shape = judge(collapse_change(mesh, collapse), rules);
  if (shape != Refusal::none) return shape;
  if (rules.cos_feature < -1) return Refusal::none;
  const bool target_moves = to != to_point(mesh.point(mesh.target(h)));
  if (leaves_feature(mesh, h, rules) ||
      (target_moves && vertex_kind(mesh, mesh.target(h), rules) != VertexKind::free))
    return Refusal::feature;
  return Refusal::none;
}

Refusal may_collapse(const Mesh& mesh, Mesh::Halfedge_index h, const CollapseRules& rules) {
  return may_collapse_to(mesh, {h, to_point(mesh.point(mesh.target(h)))}, rules);
}

Mesh::Vertex_index collapse(Mesh& mesh, Mesh::Halfedge_index h) {
  // Euler::collapse_edge keeps the end that the edge's first halfedge points to; these are its own
  // three steps, with `h` in that place.
  const auto left = mesh.opposite(mesh.prev(h));
  const auto right = mesh.opposite(mesh.prev(mesh.opposite(h)));
  const auto stays = mesh.target(h);
  CGAL::Euler::join_face(left, mesh);
  CGAL::Euler::join_face(right, mesh);
  CGAL::Euler::join_vertex(h, mesh);
  return stays;
}

}  // namespace suture::surgery
