#include "surgery/detect/zones.h"

#include <catch2/catch.hpp>

#include "surgery/check/surgery_check.h"
#include "tests/surgery/remodelled.h"

using namespace suture;
using namespace suture::surgery;

namespace {

Triangles inverted(Triangles body) {
  for (Triangle& t : body.triangles) std::swap(t[0], t[1]);
  return body;
}

Point within(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

/// Three balls that overlap each other within the sphere of radius `around`, and touch it or not.
Triangles cluster(Random& random, double around) {
  const Point at = within(random, 1).normalized() * random.uniform(0, around);
  Triangles all = ball(random.uniform(0.6, 1.4), at, 3);
  for (int more = 0; more < 2; ++more)
    all = together(all, ball(random.uniform(0.6, 1.4), at + within(random, 0.5), 3));
  return all;
}

/// How many nodes changed their side in remodels with these options, in all orders of collapses.
struct Tally {
  std::size_t commits = 0, refusals = 0, changed = 0, overlapped = 0;

  void add(const Triangles& surface, TrackerOptions options) {
    for (const Collapse order : {Collapse::straighten, Collapse::keep, Collapse::paper}) {
      options.collapse = order;
      Tracker tracker(surface, options);
      const SurgeryReport report = tracker.remodel();
      refusals += report.outcome == Outcome::refused ? 1 : 0;
      if (report.outcome != Outcome::committed) continue;
      ++commits;
      overlapped += report.marked.overlapped;
      const Lattice lattice = lattice_of(surface.positions, options);
      changed += SurfaceCheck::sides_changed(SurfaceCheck(surface, lattice),
                                             SurfaceCheck(tracker.surface(), lattice))
                     .size();
      CHECK(audit(tracker.surface()).closed_manifold());
    }
  }
};

}  // namespace

TEST_CASE("a merge of balls that touch an inverted one round them changes no side") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const double around = random.uniform(3, 5);
    const Triangles outer = inverted(ball(around, {0.01, 0.02, 0.03}, 4));
    tally.add(together(outer, cluster(random, around)),
              {.cell_size = 1, .origin = within(random, 0.5), .events = Events::merge});
  }
  CHECK(tally.commits > 60);
  CHECK(tally.refusals == 0);
  CHECK(tally.changed == 0);
  CHECK(tally.overlapped > 0);
}

TEST_CASE("a split of inverted balls that touch two nested ones round them changes no side") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const double around = random.uniform(3, 5);
    const Triangles outer =
        together(ball(around, {0.01, 0.02, 0.03}, 4), ball(around + 1.5, {0.01, 0.02, 0.03}, 4));
    tally.add(together(outer, inverted(cluster(random, around))),
              {.cell_size = 1, .origin = within(random, 0.5), .events = Events::split});
  }
  CHECK(tally.commits > 60);
  CHECK(tally.refusals == 0);
  CHECK(tally.changed == 0);
  CHECK(tally.overlapped > 0);
}

TEST_CASE("a merge inside an inverted body is done, whether splits are allowed or not") {
  const Triangles three =
      together(ball(0.9, {0.01, 0.02, 0.03}, 6),
               together(ball(0.9, {0.41, 0.02, 0.03}, 6), ball(0.9, {0.21, 0.32, 0.03}, 6)));
  const Triangles surface = together(inverted(ball(3, {0.01, 0.02, 0.03}, 6)), three);
  const Remodelled merged = remodelled(surface, {.cell_size = 0.2, .events = Events::merge});
  const Remodelled both = remodelled(surface, {.cell_size = 0.2, .events = Events::both});
  CHECK(merged.report.components_after == 1);
  CHECK(both.report.components_after == 1);
  CHECK(merged.report.marked.overlapped > 0);
  CHECK(both.report.marked.overlapped == 0);
  CHECK(volume(merged.surface) == Approx(volume(both.surface)));
}

TEST_CASE("a merge takes no everted sheet with it that it does not touch, thin or thick") {
  const Triangles balls = together(ball(1, {0.01, 0.02, 3.03}), ball(1, {1.21, 0.02, 3.03}));
  for (const double thickness : {0.02, 0.25}) {
    const Triangles plate = inverted(sheet({{0.013, 0.011, 0.05}, 2, 1, thickness, 0, 0.05}));
    const Remodelled r =
        remodelled(together(plate, balls), {.cell_size = 0.1, .events = Events::merge});
    CAPTURE(thickness);
    CHECK(r.report.outcome == Outcome::committed);
    CHECK(r.report.marked.overlapped == 0);
    CHECK(r.report.components_after == 2);
    for (std::uint32_t v = 0; v < plate.positions.size(); ++v)
      REQUIRE(r.report.vertex_map[v] != kNone);
    CHECK(volume(r.surface) - volume(remodelled(balls, {.cell_size = 0.1}).surface) ==
          Approx(volume(plate)).epsilon(1e-6));
  }
}
