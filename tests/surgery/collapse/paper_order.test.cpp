#include "surgery/collapse/paper_order.h"

#include <catch2/catch.hpp>

#include "kernel/measure/self_intersections.h"
#include "tests/surgery/hostile.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

Triangles two_balls() {
  return together(ball(1, {0.01, 0.02, 0.03}, 16), ball(0.8, {1.113, 0.207, 0.109}, 16));
}

SurgeryReport remodelled(const Triangles& surface, TrackerOptions options, Triangles* after) {
  Tracker tracker(surface, options);
  SurgeryReport report = tracker.remodel();
  if (report.outcome == Outcome::committed && !tracker.surface().triangles.empty())
    CHECK(audit(tracker.surface()).closed_manifold());
  if (after) *after = tracker.surface();
  return report;
}

}  // namespace

TEST_CASE("in the paper's order two balls merge with straight arcs only") {
  Triangles after;
  const SurgeryReport r =
      remodelled(two_balls(), {.cell_size = 0.1, .collapse = Collapse::paper}, &after);
  REQUIRE(r.outcome == Outcome::committed);
  CHECK(r.components_after == 1);
  CHECK(r.euler_after == 2);
  CHECK(r.collapses.done >= r.type2_vertices);
  CHECK(self_intersections(after).pairs.empty());
  const SurgeryReport again =
      remodelled(after, {.cell_size = 0.1, .collapse = Collapse::paper}, nullptr);
  CHECK(again.outcome == Outcome::unchanged);
}

TEST_CASE("in the paper's order hostile input gridlocks, and growing the region resolves it",
          "[slow]") {
  std::size_t operated = 0, refused = 0, restarts = 0, bent = 0, grown = 0, delayed = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    HostileCase c = HostileCases(seed).make();
    c.options.collapse = Collapse::paper;
    Triangles after;
    const SurgeryReport r = remodelled(c.surface, c.options, &after);
    CAPTURE(seed, r.failure);
    CHECK(r.outcome != Outcome::refused);
    if (r.outcome != Outcome::committed) CHECK(after == c.surface);
    operated += r.outcome == Outcome::committed ? 1 : 0;
    refused += r.outcome == Outcome::refused ? 1 : 0;
    restarts += r.regrowths;
    bent += r.bent_arcs;
    grown += r.marked.gridlocked;
    delayed += r.collapses.delayed;
    CHECK((r.regrowths == 0) == (r.marked.gridlocked == 0));
  }
  WARN(operated << " operated on, " << refused << " refused, " << restarts << " restarts, " << bent
                << " bent arcs, " << grown << " cells grown, " << delayed << " delayed");
  CHECK(operated > 200);
  CHECK(restarts > 0);
  CHECK(delayed > 0);
}
