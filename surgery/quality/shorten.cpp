// Short edges, and the shortest edges of bad triangles, are collapsed [§6.2].
#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <tuple>

#include "surgery/quality/passes.h"

namespace suture::surgery {

namespace {

struct ShortEdge {
  double length;
  Mesh::Edge_index edge;
  bool operator>(const ShortEdge& b) const {
    return std::tie(length, edge) > std::tie(b.length, b.edge);
  }
};

/// The ways to collapse one edge.
using Ways = boost::container::small_vector<EdgeCollapse, 4>;

/// The point on the normal through the edge's middle at which the collapse leaves the volume as it
/// is [Lindstrom and Turk 1998]; the middle itself where the star has no facing.
Point volume_keeping_point(const Mesh& mesh, Mesh::Halfedge_index h) {
  const Point p = to_point(mesh.point(mesh.source(h))), q = to_point(mesh.point(mesh.target(h)));
  const Point middle = (p + q) / 2;
  Point facing = Point::Zero();
  double excess = 0;
  enum class Beside { added, left_out };  // the triangles beside the edge, which both stars have
  const auto add_star = [&](Mesh::Vertex_index v, Beside beside) {
    for (const auto g : mesh.halfedges_around_target(mesh.halfedge(v))) {
      if (beside == Beside::left_out &&
          (mesh.face(g) == mesh.face(h) || mesh.face(g) == mesh.face(mesh.opposite(h))))
        continue;
      const Point n = area_vector(corners(mesh, mesh.face(g)));
      facing += n;
      excess += (to_point(mesh.point(v)) - middle).dot(n);
    }
  };
  add_star(mesh.source(h), Beside::added);
  add_star(mesh.target(h), Beside::left_out);
  const double size = facing.norm(), length = (q - p).norm();
  const double offset = size > 0 ? excess / size : 0;
  // Rounding on flat ground must not lift the point off it; far away the estimate means nothing.
  if (std::abs(offset) < 1e-9 * length || !(std::abs(offset) < length)) return middle;
  return middle + facing / size * offset;  // offset / size may overflow where the star is a sliver
}

/// Ways in order of preference, as far as features leave any.
Ways ways_to_collapse(const Improvement& work, Mesh::Halfedge_index h) {
  const Mesh& mesh = work.mesh;
  const auto back = mesh.opposite(h);
  const Point p = to_point(mesh.point(mesh.source(h))), q = to_point(mesh.point(mesh.target(h)));
  const bool source_free = vertex_kind(mesh, mesh.source(h), work.rules) == VertexKind::free;
  const bool target_free = vertex_kind(mesh, mesh.target(h), work.rules) == VertexKind::free;
  if (source_free && target_free) {
    if (work.options.subdivision == Subdivision::fitted)
      return {{h, q}, {back, p}, {h, surface_point(work, h, 0.5)}};
    // Splits on the curve and collapses that keep the volume would blow the surface up together.
    const bool curved = work.options.subdivision == Subdivision::curved;
    return {{h, curved ? surface_point(work, h, 0.5) : volume_keeping_point(mesh, h)},
            {h, q},
            {back, p}};
  }
  if (target_free) return {{back, p}, {h, q}};
  return {{h, q}, {back, p}};
}

double longest_edge(const LocalChange& change, Corners LocalChange::Pair::*when) {
  double longest = 0;
  for (const auto& t : change.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, ((t.*when)[(i + 1) % 3] - (t.*when)[i]).norm());
  return longest;
}

/// Whether the collapse leaves the star no worse than it was, or good.
bool leaves_good_shapes(const Improvement& work, Mesh::Halfedge_index h,
                        const LocalChange& change) {
  double worst = std::min(worst_before(change), work.sin_smallest_angle);
  for (const auto g : {h, work.mesh.opposite(h)})
    worst = std::min(worst, shape_of(work.mesh, work.mesh.face(g)).smallest_sine);
  return worst_after(change) >= worst &&
         longest_edge(change, &LocalChange::Pair::after) <=
             std::max(work.longest * work.scale(h),
                      longest_edge(change, &LocalChange::Pair::before));
}

/// The way chosen, or why none is.
struct Choice {
  Refusal refusal;
  EdgeCollapse way{};
};

/// The first way that the rules allow and that leaves good shapes, if any; else the first refusal.
Choice choose_good_way(const Improvement& work, Mesh::Halfedge_index h, const Ways& ways) {
  Refusal first = Refusal::none;
  const CollapseRules rules = work.rules_at(h);
  for (const EdgeCollapse& way : ways) {
    Refusal refusal = may_collapse_to(work.mesh, way, rules);
    if (refusal == Refusal::none &&
        leaves_good_shapes(work, way.h, collapse_change(work.mesh, way)))
      return {Refusal::none, way};
    if (refusal == Refusal::none) refusal = Refusal::normal;
    if (first == Refusal::none) first = refusal;
  }
  return {first};
}

/// The first way that the rules allow, if any.
std::optional<EdgeCollapse> allowed_way(const Improvement& work, const Ways& ways,
                                        const CollapseRules& rules) {
  for (const EdgeCollapse& way : ways)
    if (may_collapse_to(work.mesh, way, rules) == Refusal::none) return way;
  return std::nullopt;
}

/// An edge too short for the mesh to resolve goes even where that leaves worse shapes, or where
/// both its ends are held by features.
Choice choose_way(const Improvement& work, Mesh::Halfedge_index h) {
  const Ways ways = ways_to_collapse(work, h);
  const Choice good = choose_good_way(work, h, ways);
  if (good.refusal == Refusal::none) return good;
  if (length_of(work.mesh, h) > kFeatureScale * work.shortest * work.scale(h)) return good;
  const CollapseRules rules = work.rules_at(h);
  if (const auto way = allowed_way(work, ways, rules)) return {Refusal::none, *way};
  if (!leaves_feature(work.mesh, h, work.rules) ||
      !leaves_feature(work.mesh, work.mesh.opposite(h), work.rules))
    return good;
  CollapseRules relaxed = rules;
  relaxed.cos_feature = -2;
  if (const auto way = allowed_way(work, ways, relaxed)) return {Refusal::none, *way};
  return good;
}

bool is_wanted(const Improvement& work, Mesh::Halfedge_index h, double length) {
  if (length < work.shortest * work.scale(h)) return true;
  for (const auto g : {h, work.mesh.opposite(h)}) {
    const auto f = work.mesh.face(g);
    const Shape shape = shape_of(work.mesh, f);
    if (is_bad(shape, work) &&
        work.mesh.edge(halfedge_of(work.mesh, f, shape.shortest)) == work.mesh.edge(h))
      return true;
  }
  return false;
}

}  // namespace

std::size_t collapse_short_edges(Improvement& work) {
  Mesh& mesh = work.mesh;
  std::priority_queue<ShortEdge, std::vector<ShortEdge>, std::greater<>> queue;
  const auto push_if_wanted = [&](Mesh::Halfedge_index h) {
    const double length = length_of(mesh, h);
    if (is_wanted(work, h, length)) queue.push({length, mesh.edge(h)});
  };
  for (const auto e : mesh.edges()) push_if_wanted(mesh.halfedge(e));
  CollapseCounts refused;
  std::size_t done = 0;
  while (!queue.empty()) {
    const ShortEdge next = queue.top();
    queue.pop();
    if (mesh.is_removed(next.edge)) continue;
    const auto h = mesh.halfedge(next.edge);
    if (length_of(mesh, h) != next.length || !is_wanted(work, h, next.length)) continue;
    const Choice choice = choose_way(work, h);
    count_refusal(refused, choice.refusal);
    if (choice.refusal != Refusal::none) continue;
    const auto v = collapse(mesh, choice.way.h);
    mesh.point(v) = to_cgal(choice.way.to);
    ++done;
    for (const auto g : mesh.halfedges_around_target(mesh.halfedge(v))) {
      push_if_wanted(g);
      push_if_wanted(mesh.prev(g));
    }
  }
  refused.done = work.report.collapses.done + done;
  work.report.collapses = refused;
  return done;
}

}  // namespace suture::surgery
