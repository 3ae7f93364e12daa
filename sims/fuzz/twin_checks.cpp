// The promises about twins, and their reasons.
// - rational: the same bits. Both arithmetics are exact, positions are rounded from exact values.
// - scaling by 2^k, lengths in the options with it: the same bits, scaled. Nothing is rounded
//   differently as long as no number leaves the normal range; what is clamped next to a plane at 0
//   does: it is the least double above 0 at any scale, and triangles with it may have area at one
//   scale only. Such a vertex may have gone again where some collapse, and have decided how. Events
//   and counts are the same even so.
// - cells: the lattice's origin moved by whole cells, where the planes stay the same doubles, gives
//   the same bits. Surface and lattice moved together, where both moves are exact, meet alike, so
//   events and crossings are the same; inserted vertices have other roundings.
// - order of bodies, triangles, corners and vertices: decisions do not know numbers, so events and
//   crossings are the same; with `keep` and placement at crossings inserted vertices are the same
//   points (distances are rounded, in the order of corners and axes).
// - in the paper's order of collapses which arcs gridlock depends on numbers and roundings: where a
//   region has regrown, only what was found before is promised to be the same.
// - axes, turned cyclically: as for the order, but only without ties, which the symbolic shift
//   settles by the order of the axes.
#include "sims/fuzz/twin_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/lists.h"
#include "kernel/measure/measures.h"
#include "kernel/random.h"
#include "sims/fuzz/named_options.h"
#include "surgery/check/surgery_check.h"
#include "surgery/tracker.h"

namespace suture::sims {

namespace {

struct Twin {
  Triangles surface;
  SurgeryReport report;
};

Twin remodelled(const Triangles& surface, const TrackerOptions& options) {
  Tracker tracker(surface, options);
  SurgeryReport report = tracker.remodel();
  return {tracker.surface(), std::move(report)};
}

/// Twins cost a remodel or more each; large cases have them rarely enough as it is.
bool applies(const Observation& o) {
  constexpr std::size_t kMost = 3000;
  return o.surgery != nullptr && o.surgery->outcome != Outcome::refused &&
         !o.before.triangles.empty() && o.before.triangles.size() <= kMost &&
         o.options.arithmetic == Arithmetic::filtered;
}

/// Whether pieces could not be merged in one of the two: that depends on rounded positions and on
/// where a polygon starts, and adds type 1 vertices.
bool split_triangles(const SurgeryReport& a, const SurgeryReport& b) {
  return a.split_triangles != 0 || b.split_triangles != 0;
}

/// Events and crossings; the words of the first that differs.
Objection compare_counts(const SurgeryReport& a, const SurgeryReport& b) {
  const auto differ = [](const char* what, auto x, auto y) -> Objection {
    if (x == y) return {};
    return fmt::format("{}: {} and {}", what, static_cast<std::int64_t>(x),
                       static_cast<std::int64_t>(y));
  };
  for (const Objection& d :
       {differ("outcome", a.outcome, b.outcome), differ("crossings", a.crossings, b.crossings),
        differ("complex cells", a.complex_cells, b.complex_cells),
        differ("deep inside", a.marked.deep_inside, b.marked.deep_inside),
        differ("deep outside", a.marked.deep_outside, b.marked.deep_outside),
        differ("self-intersecting", a.marked.self_intersecting, b.marked.self_intersecting),
        differ("inverted", a.marked.inverted, b.marked.inverted),
        differ("flooded", a.marked.flooded, b.marked.flooded)})
    if (d) return d;
  if (a.regrowths != 0 || b.regrowths != 0) return {};
  for (const Objection& d :
       {split_triangles(a, b) ? Objection{} : differ("type 1", a.type1_vertices, b.type1_vertices),
        differ("isosurface", a.isosurface_vertices, b.isosurface_vertices),
        differ("loops", a.loops, b.loops),
        differ("coincident", a.coincident_triangles, b.coincident_triangles),
        differ("Euler characteristic", a.euler_after, b.euler_after),
        differ("components", a.components_after, b.components_after)})
    if (d) return d;
  return {};
}

std::vector<std::array<double, 3>> sorted_points(const Triangles& surface) {
  std::vector<std::array<double, 3>> points;
  for (const Point& p : surface.positions) points.push_back({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0});
  std::sort(points.begin(), points.end());
  return points;
}

/// With `keep` every inserted vertex is a crossing, which numbering has no part in; but a centroid
/// is summed in the order of its loop.
bool points_are_promised(const Observation& o, const Twin& twin) {
  return o.options.collapse == Collapse::keep && o.options.placement == Placement::crossing &&
         o.surgery->centroid_vertices == 0 && o.surgery->split_triangles == 0 &&
         twin.report.split_triangles == 0;
}

Triangles scaled_exactly(Triangles surface, double factor) {
  for (Point& p : surface.positions) p *= factor;
  return surface;
}

bool has_subnormals(const Triangles& surface) {
  for (const Point& p : surface.positions)
    for (int a = 0; a < 3; ++a)
      if (std::fpclassify(p[a]) == FP_SUBNORMAL) return true;
  return false;
}

bool has_plane_at_zero(const Observation& o) {
  const Lattice lattice = lattice_of(o.before.positions, o.options);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < lattice.planes(axis); ++i)
      if (lattice.plane(axis, i) == 0) return true;
  return false;
}

Triangles turned(const Triangles& surface) {
  Triangles result = surface;
  for (Point& p : result.positions) p = Point(p[2], p[0], p[1]);
  return result;
}

template <class T>
std::vector<std::size_t> shuffled(const std::vector<T>& list, Random& random) {
  std::vector<std::size_t> order = identity_map<std::size_t>(list.size());
  shuffle(order, random);
  return order;
}

Triangles reordered(const Triangles& surface, Random& random) {
  Triangles result;
  const auto vertices = shuffled(surface.positions, random);
  std::vector<std::uint32_t> now(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    now[vertices[v]] = static_cast<std::uint32_t>(v);
    result.positions.push_back(surface.positions[vertices[v]]);
  }
  for (const std::size_t t : shuffled(surface.triangles, random)) {
    const Triangle& old = surface.triangles[t];
    const std::size_t r = random.below(3);
    result.triangles.push_back({now[old[r]], now[old[(r + 1) % 3]], now[old[(r + 2) % 3]]});
  }
  return result;
}

bool planes_moved_exactly(const Lattice& a, const Lattice& b, const Point& by) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.planes(axis) != b.planes(axis)) return false;
    for (int i = 0; i < a.planes(axis); ++i)
      if (a.plane(axis, i) + by[axis] != b.plane(axis, i) ||
          b.plane(axis, i) - by[axis] != a.plane(axis, i))
        return false;
  }
  return true;
}

}  // namespace

Objection check_rational(const Observation& o) {
  if (!applies(o)) return {};
  TrackerOptions options = o.options;
  options.arithmetic = Arithmetic::rational;
  const Twin twin = remodelled(o.before, options);
  if (const auto d = compare_counts(*o.surgery, twin.report)) return "rational: " + *d;
  if (!same_bits(twin.surface, o.after)) return "rational arithmetic gives other bits";
  return {};
}

Objection check_scaling(const Observation& o) {
  if (!applies(o)) return {};
  Random random(o.seed);
  const int k = static_cast<int>(random.below(81)) - 40;
  const double factor = std::ldexp(1.0, k);
  const Triangles twin_before = scaled_exactly(o.before, factor);
  if (!same_bits(scaled_exactly(twin_before, 1 / factor), o.before) || has_subnormals(o.before))
    return {};
  TrackerOptions options = o.options;
  scale_lengths(options, k);
  const Twin twin = remodelled(twin_before, options);
  if (const auto d = compare_counts(*o.surgery, twin.report))
    return fmt::format("times 2^{}: {}", k, *d);
  if (has_subnormals(o.after) || has_subnormals(twin.surface)) return {};
  if (o.options.collapse != Collapse::keep && has_plane_at_zero(o)) return {};
  if (!same_bits(twin.surface, scaled_exactly(o.after, factor)))
    return fmt::format("times 2^{} the bits are others", k);
  return {};
}

Objection check_axes(const Observation& o) {
  if (!applies(o) || count_ties(o.before, lattice_of(o.before.positions, o.options)) != 0)
    return {};
  TrackerOptions options = o.options;
  options.origin = Point(options.origin[2], options.origin[0], options.origin[1]);
  const Twin twin = remodelled(turned(o.before), options);
  if (const auto d = compare_counts(*o.surgery, twin.report)) return "axes turned: " + *d;
  if (points_are_promised(o, twin) && sorted_points(turned(o.after)) != sorted_points(twin.surface))
    return "axes turned: other points";
  return {};
}

Objection check_cells(const Observation& o) {
  if (!applies(o)) return {};
  Random random(o.seed);
  Point by;
  for (int a = 0; a < 3; ++a)
    by[a] = o.options.cell_size * (static_cast<double>(random.below(9)) - 4);
  const Lattice lattice = lattice_of(o.before.positions, o.options);
  TrackerOptions options = o.options;
  options.origin += by;
  if (lattice_of(o.before.positions, options) == lattice &&
      !same_bits(remodelled(o.before, options).surface, o.after))
    return "the origin moved by whole cells, the planes are the same, but the bits are others";
  Triangles moved = o.before;
  for (std::size_t v = 0; v < moved.positions.size(); ++v) {
    moved.positions[v] += by;
    if (moved.positions[v] - by != o.before.positions[v]) return {};
  }
  if (!planes_moved_exactly(lattice, lattice_of(moved.positions, options), by)) return {};
  const Twin twin = remodelled(moved, options);
  if (const auto d = compare_counts(*o.surgery, twin.report)) return "moved by whole cells: " + *d;
  return {};
}

Objection check_order(const Observation& o) {
  if (!applies(o)) return {};
  Random random(o.seed);
  const Twin twin = remodelled(reordered(o.before, random), o.options);
  if (const auto d = compare_counts(*o.surgery, twin.report)) return "reordered: " + *d;
  if (points_are_promised(o, twin) && sorted_points(o.after) != sorted_points(twin.surface))
    return "reordered: other points";
  return {};
}

}  // namespace suture::sims
