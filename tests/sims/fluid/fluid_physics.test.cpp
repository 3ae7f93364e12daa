#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/audit.h"
#include "tests/sims/fluid/liquids.h"
#include "tests/sims/fluid/runs.h"

using namespace suture;
using namespace suture::sims;

namespace {

double order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

}  // namespace

TEST_CASE("still water stays still for 1,000 steps, however coarse its grid") {
  const double height = 0.437;
  FluidOptions options;
  options.cell_size = 0.25;
  options.gravity = {0, -10, 0};
  options.pressure.tolerance = 1e-12;
  options.solids = {container({0, 0, 0}, {1, 1, 0.25})};
  Run run(block({0, 0, 0}, {1, height, 0.25}, 0.25), 0.25, options, at_rest, kMarkers);
  double most = 0;
  for (int i = 0; i < 1000; ++i) {
    run.fluid.step(*run.surface, 0.02);
    most = std::max(most, run.fastest());
  }
  CHECK(most < 1e-6 * std::sqrt(10 * height));  // measured: 1e-14
  CHECK(run.volume() == Approx(height / 4).epsilon(1e-9));
}

TEST_CASE("a projection leaves what divergence its tolerance says, over ten decades") {
  CarvedBallParameters p;
  p.edge_length = 0.15;
  const Solids walls{{Solid::box({{0.4, 0.1, -2}, {2, 2, 2}})}};
  const LiquidScene scene(carved_ball(p), 0.1, walls);
  const auto largest = [&](const MacVelocity& v) {
    double most = 0;
    for (Slot s = 0; s < scene.grid.size(); ++s)
      if (scene.liquid.inside(s)) most = std::max(most, std::abs(scene.outflow(v, s)));
    return most;
  };
  for (int digits = 2; digits <= 12; digits += 2) {
    MacVelocity v = scene.velocity([](const Point& q) -> Point {
      return {std::sin(3 * q[1]) + q[0] * q[2], std::cos(2 * q[0]) - q[1], 0.3 * q[2]};
    });
    const double before = largest(v);
    SolverOptions options;
    options.tolerance = std::pow(10, -digits);
    CHECK(project(v, scene.input(), options).converged());
    CAPTURE(digits);
    CHECK(largest(v) < 2 * options.tolerance * before);  // measured: 0.2 to 0.6 of the tolerance
  }
}

TEST_CASE("a vortex that fills a slippery box is steady, to first order in the step") {
  std::vector<double> lost;
  for (const int cells : {8, 16}) {
    Vortex v(cells, 1, {});
    v.advance(1, 2 * cells / 3);
    const auto [part, rest] = v.part();
    lost.push_back(1 - part);
    CHECK(rest < 0.05);
    CHECK(lost.back() > 0);
  }
  CAPTURE(lost);
  CHECK(lost[1] < 0.025);
  CHECK(order(lost[0], lost[1]) > 0.7);
}

TEST_CASE("viscosity slows a slow vortex at the exact rate, to second order") {
  std::vector<double> errors;
  for (const int cells : {8, 16}) {
    FluidOptions options;
    options.viscosity = 0.05;
    Vortex v(cells, 1e-4, options);
    const int steps = cells * cells / 8;
    const double dt = 0.64 / 0.1 / steps;
    v.advance(dt, 1);
    const double first = v.part().first;
    v.advance(dt * (steps - 1), steps - 1);
    errors.push_back(std::log(first / v.part().first) / (dt * (steps - 1)) / 0.1 - 1);
  }
  CAPTURE(errors);
  CHECK(std::abs(errors[1]) < 0.02);  // measured: -0.013, after -0.050
  CHECK(order(errors[0], errors[1]) > 1.7);
}

TEST_CASE("a ball that flies is where it should be, and keeps its twist") {
  const Point drift(0.53, 0.21, 0.11);
  Run rigid = twisted_ball(6, 0, {}, drift);
  const std::vector<Point> start = rigid.points();
  for (int i = 0; i < 6; ++i) rigid.fluid.step(*rigid.surface, 1.0 / 6);
  for (std::size_t i = 0; i < start.size(); ++i)
    REQUIRE((rigid.points()[i] - start[i] - drift).norm() < 1e-13);

  std::vector<double> errors;
  for (const int cells : {6, 12}) {
    Run run = twisted_ball(cells, 1e-3, {}, drift);
    for (int i = 0; i < cells; ++i) run.fluid.step(*run.surface, 1.0 / cells);
    errors.push_back(twisted(run.fluid, 1e-3, kMiddle + (1 - 0.5 / cells) * drift, drift).second);
  }
  CAPTURE(errors);
  CHECK(errors[1] < 0.15);  // measured: 0.138, after 0.337: of the twist, not of the drift
  CHECK(order(errors[0], errors[1]) > 1.1);
}

TEST_CASE("what strain is left beyond yield is less than what was beyond it, and not little") {
  constexpr double kYield = 0.001;
  const auto [within, sprung] = lasting_strain(4, 4 * kYield, kYield);
  CAPTURE(within / kYield, sprung / kYield);
  CHECK(within < kYield);
  CHECK(std::abs(sprung) < 0.1 * within);
  const auto [beyond, kept] = lasting_strain(4, 32 * kYield, kYield);
  CAPTURE(beyond / kYield, kept / kYield);
  CHECK(beyond > 2 * kYield);
  CHECK(kept > 0.5 * (beyond - kYield));
  CHECK(kept < beyond);
}

TEST_CASE("a column of water that is let go begins to fall as potential theory says") {
  CHECK(exact_fall_at_wall(1) == Approx(0.5).epsilon(1e-3));
  for (const int n2 : {1, 2}) {
    const double exact = exact_fall_at_wall(n2);
    const double coarse = fall_at_wall(n2, 8) / exact - 1, fine = fall_at_wall(n2, 16) / exact - 1;
    CAPTURE(n2, coarse, fine);
    CHECK(std::abs(coarse) < 1e-3);  // measured: 2e-7 by symmetry, and -8e-4
    CHECK(order(coarse, fine) > 1.7);
  }
}

TEST_CASE("two drops that meet keep their momentum, volume and no more than their energy") {
  const double h = 1.0 / 6;
  FluidOptions options;
  options.cell_size = h;
  options.density = 1;
  options.volume_control.emplace();
  const Triangles start = merged(std::vector{
      sphere({.centre = kMiddle, .edge_length = h, .exact_volume = 1}),
      sphere({.centre = kMiddle + Point(2.2, 0.5, 0), .edge_length = h, .exact_volume = 1})});
  const Point velocity(1, 0.1, 0.05);
  Run run(
      start, h, options,
      [&](const Point& p) -> Point { return p[0] < 1.1 ? velocity : Point::Zero(); }, kPerFrame);
  const double ball = 4 * std::numbers::pi / 3, whole = volume(start);
  for (int i = 0; i < 30; ++i) {
    run.frame(0.05);
    const LiquidMeasures now = run.fluid.measures();
    CHECK((now.momentum / ball - velocity).norm() < 0.07);
    CHECK(run.volume() == Approx(whole).epsilon(0.02));
    CHECK(now.kinetic_energy < 1.01 * ball * velocity.squaredNorm() / 2);
  }
  CHECK(components(run.surface->surface()).count == 1);
}

TEST_CASE("a thick column under a plate buckles, nearly as fast as a slender one") {
  PressedColumn column(1.0 / 30);
  double early = 0;
  for (int i = 0; i < 20; ++i) {
    column.run.frame(0.1);
    if (i == 4) early = std::log(column.aside() / column.bend);
  }
  // Measured: 1.27 of 1.44 at a shortening of a twentieth; 1.17 and 1.18 on grids of 60 and 80.
  CHECK(early > 1);
  CHECK(early < 1.45);
  CHECK(column.aside() > column.width);
  CHECK(column.height() == Approx(0.8));
  CHECK(column.run.volume() == Approx(0.01).epsilon(0.01));
  CHECK(audit(column.run.surface->surface()).closed_manifold());
}
