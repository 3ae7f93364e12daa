// Bodies that surgery leaves nothing of are named, and those that merge are not.
#include "surgery/check/vanished.h"

#include <catch2/catch.hpp>

#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "surgery/tracker.h"

using namespace suture;

namespace {

Triangles ball_at(double x, double radius) {
  return translated(sphere({.radius = radius, .frequency = 6}), {x, 0.013, 0.017});
}

SurgeryReport remodelled(const std::vector<Triangles>& bodies, double scale = 1) {
  TrackerOptions options;
  options.cell_size = 0.1 * scale;
  options.depth = 0;
  Tracker tracker(scaled(merged(bodies), scale), options);
  return tracker.remodel();
}

}  // namespace

TEST_CASE("a body smaller than a cell is named with its volume and place when it vanishes") {
  const SurgeryReport report = remodelled({ball_at(0, 0.5), ball_at(2.05, 0.02)});
  REQUIRE(report.outcome == Outcome::committed);
  REQUIRE(report.vanished.size() == 1);
  CHECK(report.components_after == 1);
  CHECK(report.vanished[0].centre[0] == Approx(2.05));
  CHECK(report.vanished[0].volume == Approx(3.2e-5).epsilon(0.1));
}

TEST_CASE("a body that merges, or stays, has not vanished") {
  const SurgeryReport merged = remodelled({ball_at(0, 0.5), ball_at(0.45, 0.06)});
  REQUIRE(merged.outcome == Outcome::committed);
  CHECK(merged.components_after == 1);
  CHECK(merged.vanished.empty());
  const SurgeryReport apart = remodelled({ball_at(0, 0.5), ball_at(2, 0.4)});
  CHECK(apart.components_after == 2);
  CHECK(apart.vanished.empty());
}

TEST_CASE("what vanished is told in the scene's own unit") {
  const double scale = 0x1p-300;
  const SurgeryReport report = remodelled({ball_at(0, 0.5), ball_at(2.05, 0.02)}, scale);
  REQUIRE(report.vanished.size() == 1);
  CHECK(report.vanished[0].centre[0] / scale == Approx(2.05));
  CHECK(report.vanished[0].volume / scale / scale / scale == Approx(3.2e-5).epsilon(0.1));
}
