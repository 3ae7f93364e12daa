// Edges of bad triangles are flipped where the smallest angle grows [§6.2].
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <deque>
#include <utility>

#include "surgery/quality/passes.h"

namespace suture::surgery {

namespace {

/// The two triangles beside an edge, each before paired with each after.
LocalChange flip_change(const Mesh& mesh, Mesh::Halfedge_index h) {
  const Point a = to_point(mesh.point(mesh.source(h))), b = to_point(mesh.point(mesh.target(h)));
  const Point c = to_point(mesh.point(mesh.target(mesh.next(h))));
  const Point d = to_point(mesh.point(mesh.target(mesh.next(mesh.opposite(h)))));
  LocalChange change;
  for (const Corners& before : {Corners{a, b, c}, Corners{b, a, d}})
    for (const Corners& after : {Corners{c, d, b}, Corners{d, c, a}})
      change.triangles.push_back({before, after});
  change.swept.push_back({a, b, c, d});
  return change;
}

/// A flip may not make a crease sharper than it found, unless both are smooth.
bool makes_crease(const LocalChange& change, const CollapseRules& rules) {
  const auto cosine = [](const Corners& s, const Corners& t) {
    const Point m = area_vector(s), n = area_vector(t);
    return m.dot(n) / std::max(m.norm() * n.norm(), 1e-300);
  };
  const double was = cosine(change.triangles[0].before, change.triangles[2].before);
  const double is = cosine(change.triangles[0].after, change.triangles[1].after);
  return is < std::max(rules.cos_feature, 0.) && is < was;
}

Refusal may_flip(const Improvement& work, Mesh::Halfedge_index h, const LocalChange& change) {
  const Mesh& mesh = work.mesh;
  const CollapseRules rules = work.rules_at(h);
  const auto c = mesh.target(mesh.next(h)), d = mesh.target(mesh.next(mesh.opposite(h)));
  if (c == d || mesh.halfedge(c, d).is_valid()) return Refusal::link;
  const Refusal refusal = judge(change, rules);
  if (refusal != Refusal::none) return refusal;
  if (makes_crease(change, rules)) return Refusal::normal;
  return is_feature(mesh, mesh.edge(h), rules) ? Refusal::feature : Refusal::none;
}

/// A smaller gain is within the rounding of two sines, which depend on the corner that a triangle
/// starts from: flips for it could go round in circles.
constexpr double kLeastGain = 1e-12;

/// The edge of `f` whose flip gains the most, if any may be flipped.
Mesh::Halfedge_index best_flip(Improvement& work, Mesh::Face_index f) {
  auto best = Mesh::null_halfedge();
  double best_gain = kLeastGain;
  bool refused = false;
  for (const auto h : work.mesh.halfedges_around_face(work.mesh.halfedge(f))) {
    const LocalChange change = flip_change(work.mesh, h);
    const double gain = worst_after(change) - worst_before(change);
    if (!(gain > best_gain)) continue;
    if (may_flip(work, h, change) == Refusal::none) {
      best = h;
      best_gain = gain;
    } else {
      refused = true;
    }
  }
  if (refused && !best.is_valid()) ++work.report.refused_flips;
  return best;
}

}  // namespace

std::size_t flip_bad_edges(Improvement& work) {
  Mesh& mesh = work.mesh;
  std::deque<Mesh::Face_index> queue;
  std::vector<bool> queued(mesh.num_faces(), false);
  const auto push_if_bad = [&](Mesh::Face_index f) {
    if (queued[f] || !is_bad(shape_of(mesh, f), work)) return;
    queued[f] = true;
    queue.push_back(f);
  };
  for (const auto f : mesh.faces()) push_if_bad(f);
  std::size_t done = 0;
  while (!queue.empty()) {
    const auto f = queue.front();
    queue.pop_front();
    queued[f] = false;
    const auto h = best_flip(work, f);
    if (!h.is_valid()) continue;
    CGAL::Euler::flip_edge(h, mesh);
    ++done;
    push_if_bad(mesh.face(h));
    push_if_bad(mesh.face(mesh.opposite(h)));
  }
  work.report.flips += done;
  return done;
}

namespace {

/// The foot of the obtuse corner on its triangle's longest edge `h`, or on the surface over it.
Point foot_on(const Improvement& work, Mesh::Halfedge_index h) {
  const Mesh& mesh = work.mesh;
  const Point a = to_point(mesh.point(mesh.source(h)));
  const Point along = to_point(mesh.point(mesh.target(h))) - a;
  const Point apex = to_point(mesh.point(mesh.target(mesh.next(h))));
  const double part = along.dot(apex - a) / along.squaredNorm();
  const bool fitted = work.options.subdivision == Subdivision::fitted;
  return fitted ? surface_point(work, h, part) : Point(a + along * part);
}

/// Splits `h` at the foot and collapses the obtuse corner onto it, if that is allowed and leaves no
/// angle with a sine as small as `sine`; else takes the split back. \return whether it was done
bool flatten_onto(Improvement& work, Mesh::Halfedge_index h, double sine) {
  Mesh& mesh = work.mesh;
  const Point foot = foot_on(work, h);
  if (judge(split_change(mesh, h, foot), work.rules_at(h)) != Refusal::none) return false;
  const double scale = work.scale(h);
  const auto stay = mesh.source(h);
  const auto moved = mesh.target(mesh.next(h));
  const auto v = split_edge(mesh, h, foot);
  if (work.options.chord_error > 0) work.scales[v] = scale;
  const auto drop = mesh.halfedge(moved, v);
  const bool done = worst_after(collapse_change(mesh, {drop, foot})) > sine &&
                    may_collapse(mesh, drop, work.rules_at(drop)) == Refusal::none;
  collapse(mesh, done ? drop : mesh.halfedge(v, stay));
  return done;
}

}  // namespace

std::size_t flatten_caps(Improvement& work) {
  Mesh& mesh = work.mesh;
  std::size_t done = 0;
  const auto count = mesh.num_faces();
  for (Mesh::size_type i = 0; i < count; ++i) {
    const Mesh::Face_index f(i);
    if (mesh.is_removed(f)) continue;
    const Shape shape = shape_of(mesh, f);
    if (!is_bad(shape, work) || shape.largest_cosine >= 0) continue;
    if (flatten_onto(work, halfedge_of(mesh, f, shape.longest), shape.smallest_sine)) ++done;
  }
  work.report.flattened += done;
  return done;
}

}  // namespace suture::surgery
