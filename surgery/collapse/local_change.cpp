// One local operation is judged by its normals, lattice nodes and volume [§6.2].
#include "surgery/collapse/local_change.h"

#include <algorithm>
#include <cmath>

namespace suture::surgery {

namespace {

/// The sum of the star's area vectors: it faces that way, whatever its slivers say.
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
  if (rules.nodes && any_holds_node({change.swept.data(), change.swept.size()}, *rules.nodes))
    return Refusal::node;
  if (volume_moved(change) > rules.volume_bound) return Refusal::volume;
  return Refusal::none;
}

LocalChange collapse_change(const Mesh& mesh, const EdgeCollapse& collapse,
                            const FaceMarks* doomed) {
  const Mesh::Halfedge_index h = collapse.h;
  const Point& to = collapse.to;
  enum class Beside { added, left_out };  // the triangles beside the edge, which both stars have
  LocalChange change;
  const auto add_star = [&](Mesh::Vertex_index v, Beside beside) {
    const Point from = to_point(mesh.point(v));
    if (from == to) return;
    for (const auto g : mesh.halfedges_around_target(mesh.halfedge(v))) {
      if (doomed && (*doomed)[mesh.face(g)] != 0) continue;
      const bool goes = around(mesh, g, h);
      if (goes && beside == Beside::left_out) continue;
      const Point a = to_point(mesh.point(mesh.target(mesh.next(g))));
      const Point b = to_point(mesh.point(mesh.source(g)));
      if (!goes) change.triangles.push_back({{from, a, b}, {to, a, b}});
      if (a != to && b != to) change.swept.push_back({from, to, a, b});
    }
  };
  add_star(mesh.source(h), Beside::added);
  add_star(mesh.target(h), Beside::left_out);  // they have no extent left by then
  return change;
}

namespace {

/// Does not walk round the whole star: a vertex may have any number of triangles.
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

}  // namespace suture::surgery
