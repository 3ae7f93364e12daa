#include "sims/fluid/effects/volume_control.h"

#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/fluid/liquid/component_tracking.h"
#include "surgery/tracker.h"

using namespace suture;
using namespace suture::sims;

namespace {

Triangles ball(const Point& centre, double radius, double edge = 0.1) {
  return sphere({centre, radius, edge});
}

Triangles together(const std::vector<Triangles>& surfaces) { return merged(surfaces); }

double total_target(const VolumeControl& control) {
  double sum = 0;
  for (const VolumeControl::Body& b : control.bodies()) sum += b.target;
  return sum;
}

/// Moves vertices by a function of where they are.
template <class F>
void displace(Tracker& tracker, F f) {
  std::vector<Point> to = tracker.surface().positions;
  for (Point& p : to) p = f(p);
  tracker.displace(to);
}

SurgeryReport remodel(Tracker& tracker, VolumeControl& control) {
  control.before_remodel(tracker.surface());
  const SurgeryReport report = tracker.remodel();
  tracker.improve();
  control.after_remodel(tracker.surface());
  return report;
}

}  // namespace

TEST_CASE("two drops that merge hand their targets on") {
  Tracker tracker(together({ball({-1.1, 0, 0}, 1), ball({1.1, 0, 0}, 1), ball({0, 4, 0}, 0.5)}),
                  {.cell_size = 0.1});
  VolumeControl control(tracker.surface());
  REQUIRE(control.bodies().size() == 3);
  const double before = total_target(control), small = control.bodies()[2].target;
  displace(tracker, [](Point p) {
    if (p[1] < 2) p[0] -= std::copysign(0.13, p[0]);
    return Point(0.99 * p);
  });
  control.moved(tracker.surface());
  CHECK(control.bodies()[0].volume == Approx(std::pow(0.99, 3) * control.bodies()[0].target));
  const SurgeryReport report = remodel(tracker, control);
  REQUIRE(report.outcome == Outcome::committed);
  REQUIRE(control.bodies().size() == 2);
  CHECK(total_target(control) == Approx(before).epsilon(1e-15));
  CHECK(control.bodies()[0].target + control.bodies()[1].target == Approx(before).epsilon(1e-15));
  CHECK(std::min(control.bodies()[0].target, control.bodies()[1].target) == small);
}

TEST_CASE("a drop that splits shares its target out by volume") {
  Triangles start = dumbbell({{0.01, 0.05, 0.03}, 0.5, 2.4, 0.005, 0.2, 0.05});
  for (Point& p : start.positions)
    if (p[2] > 0) p *= 1.1;
  Tracker tracker(start, {.cell_size = 0.1});
  VolumeControl control(tracker.surface());
  const double before = total_target(control);
  displace(tracker, [](const Point& p) { return Point(0.99 * p); });
  control.moved(tracker.surface());
  const SurgeryReport report = remodel(tracker, control);
  REQUIRE(report.outcome == Outcome::committed);
  CHECK(total_target(control) == Approx(before).epsilon(1e-15));
  REQUIRE(control.bodies().size() >= 2);
  const auto& [a, b] = std::tie(control.bodies()[0], control.bodies()[1]);
  CHECK(a.target / a.volume == Approx(b.target / b.volume).epsilon(1e-12));
  CHECK(std::abs(a.volume / b.volume - 1) > 0.2);
  CHECK(a.target > 1.02 * a.volume);
}

TEST_CASE("bodies that share no vertex are told apart by where they have come to") {
  // Small drops that fly further than they are wide, and each to where the other was.
  const auto drops = [](double first, double second, int frequency) {
    return together({sphere({Point(0, 0, 0), first, 1, frequency}),
                     sphere({Point(1, 0, 0), second, 1, frequency})});
  };
  VolumeControl control(drops(0.11, 0.1, 3));
  control.moved(drops(0.1, 0.1, 3));
  const double larger = control.bodies()[0].target, smaller = control.bodies()[1].target;
  VolumeControl unaware = control;
  const Triangles after = translated(drops(0.1, 0.1, 4), {1, 0, 0});
  for (VolumeControl* c : {&control, &unaware}) c->before_remodel(drops(0.1, 0.1, 3));
  control.after_remodel(after, [](const Point& p) { return Point(p + Point(1, 0, 0)); });
  REQUIRE(control.bodies().size() == 2);
  CHECK(control.bodies()[0].target == larger);
  CHECK(control.bodies()[1].target == smaller);
  unaware.after_remodel(after);  // takes the first for the second; the rest has no other side
  for (const VolumeControl::Body& b : unaware.bodies())
    CHECK(b.target == Approx((larger + smaller) / 2).epsilon(1e-12));
}

TEST_CASE("a drop swallowed whole by a surgery gives its target to what swallowed it") {
  const Triangles large = ball({0, 0, 0}, 1), small = ball({1.05, 0, 0}, 0.2, 0.05);
  Tracker tracker(together({large, small}), {.cell_size = 0.1});
  VolumeControl control(tracker.surface());
  const double before = total_target(control);
  const SurgeryReport report = remodel(tracker, control);
  REQUIRE(report.outcome == Outcome::committed);
  REQUIRE(control.bodies().size() == 1);
  CHECK(control.bodies()[0].target == Approx(before).epsilon(1e-15));
}

TEST_CASE("a drop of which nothing is left hands its target to the largest body") {
  const Triangles pool = ball({0, 0, 0}, 1), medium = ball({5, 0, 0}, 0.5),
                  mist = ball({6, 0, 0}, 0.01, 0.01);
  VolumeControl control(together({medium, pool, mist}));
  const double before = total_target(control), medium_one = control.bodies()[0].target;
  control.before_remodel(together({medium, pool, mist}));
  control.after_remodel(together({medium, pool}));
  REQUIRE(control.bodies().size() == 2);
  CHECK(control.bodies()[0].target == medium_one);
  CHECK(total_target(control) == Approx(before).epsilon(1e-15));
  control.before_remodel(
      together({medium, pool}));  // and what comes from nothing has it from there
  control.after_remodel(together({medium, pool, mist}));
  CHECK(control.bodies()[0].target == medium_one);
  CHECK(control.bodies()[2].target == Approx(volume(mist)).epsilon(1e-6));
  CHECK(total_target(control) == Approx(before).epsilon(1e-15));
  control.before_remodel(together({medium, pool, mist}));
  control.after_remodel({});
  CHECK(control.bodies().empty());
  control.before_remodel({});
  control.after_remodel(pool);
  CHECK(control.bodies()[0].target == volume(pool));
}

TEST_CASE("volume control refuses what it cannot make sense of") {
  const Triangles s = ball({0, 0, 0}, 1);
  CHECK_THROWS_AS(VolumeControl(s, {.relaxation = 2}), InvalidInput);
  CHECK_THROWS_AS(VolumeControl(s, {.damping = 0}), InvalidInput);
  CHECK_THROWS_AS(VolumeControl(s, {.most_shift = 0}), InvalidInput);
  CHECK_THROWS_AS(VolumeControl(s, {.most_integral = -1}), InvalidInput);
  VolumeControl control(s);
  CHECK_THROWS_AS(control.moved(ball({0, 0, 0}, 1, 0.2)), InvalidInput);
  CHECK_THROWS_AS(control.after_remodel(s), InvalidInput);
  control.before_remodel(s);
  CHECK_THROWS_AS(control.moved(s), InvalidInput);
}
