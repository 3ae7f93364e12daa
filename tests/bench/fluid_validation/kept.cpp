// What has to stay as it is: still water, divergence after a projection, volume, momentum.
#include <fmt/format.h>

#include <cmath>

#include "tests/bench/fluid_validation/equal_steps.h"
#include "tests/bench/fluid_validation/validation.h"
#include "tests/sims/fluid/liquids.h"

namespace suture {

using namespace suture::sims;

void still_water(Rows& rows) {
  const double height = 0.437, cell = 0.125;
  for (const double tolerance : {1e-6, 1e-12}) {
    rows.restart();
    FluidOptions options;
    options.cell_size = cell;
    options.gravity = {0, -10, 0};
    options.pressure.tolerance = tolerance;
    options.solids = {container({0, 0, 0}, {1, 1, 0.5})};
    Run run(block({0, 0, 0}, {1, height, 0.5}, cell), cell, options, at_rest, kMarkers);
    double most = 0, since = 0;
    for (int i = 1; i <= 1000; ++i) {
      run.fluid.step(*run.surface, 0.02);
      const double now = run.fastest() / std::sqrt(10 * height);
      most = std::max(most, now);
      since = std::max(since, now);
      if (i % 20 != 0 && i > 20) continue;
      rows.add("_velocity", tolerance, i, since, 0);
      since = 0;
    }
    rows.add("_most", tolerance, 1000, most, 0);
    rows.add("_volume", tolerance, 1000, run.volume(), height / 2);
  }
}

/// A ball with hollows between a moving ball and a block, of a swirl: what of its divergence is
/// left, the largest over the largest before.
void projections(Rows& rows) {
  CarvedBallParameters p;
  p.edge_length = 0.15;
  SolidMotion motion;
  motion.velocity = Point(0.3, -0.2, 0.5);
  const Solids walls{
      {Solid::ball(Point(-0.1, -0.7, 0.2), 0.3, motion), Solid::box({{0.4, 0.1, -2}, {2, 2, 2}})}};
  for (const int cells : {10, 20}) {
    const LiquidScene scene(carved_ball(p), 1.0 / cells, walls);
    const auto largest = [&](const MacVelocity& v) {
      double most = 0;
      for (Slot s = 0; s < scene.grid.size(); ++s)
        if (scene.liquid.inside(s)) most = std::max(most, std::abs(scene.outflow(v, s)));
      return most;
    };
    for (int digits = 2; digits <= 12; ++digits) {
      rows.restart();
      MacVelocity v = scene.velocity([](const Point& q) -> Point {
        return {std::sin(3 * q[1]) + q[0] * q[2], std::cos(2 * q[0]) - q[1],
                q[0] * q[1] + 0.3 * q[2]};
      });
      const double before = largest(v);
      SolverOptions options;
      options.tolerance = std::pow(10, -digits);
      const SolveReport report = project(v, scene.input(), options);
      rows.add("_divergence", cells, options.tolerance, largest(v) / before, 0);
      rows.add("_iterations", cells, options.tolerance, report.iterations, 0);
    }
  }
}

/// Water that slants, let go: to and fro for ten seconds, the tank is 1 wide and gravity 10.
static void slosh(Rows& rows, bool control) {
  const double cell = 1.0 / 16;
  FluidOptions options;
  options.cell_size = cell;
  options.gravity = {0, -10, 0};
  if (control) options.volume_control.emplace();
  options.solids = {container({0, 0, 0}, {1, 1, 0.5})};
  Triangles water = block({0, 0, 0}, {1, 0.5, 0.5}, cell);
  for (Point& p : water.positions) p[1] *= 1 + 0.4 * (1 - 2 * p[0]);
  Run run(water, cell, options, at_rest, kPerFrame);
  const double whole = volume(water);
  for (int i = 1; i <= 400; ++i) {
    frame_of_equal_steps(run, 0.05);
    if (i % 8 == 0) rows.add(control ? "_controlled" : "_free", 16, 0.05 * i, run.volume(), whole);
  }
}

void sloshing(Rows& rows) {
  for (const bool control : {false, true}) {
    rows.restart();
    slosh(rows, control);
  }
}

/// One drop hits another, off its middle. Radii are 1.
static void meeting(Rows& rows, int cells, bool control) {
  const double h = 1.0 / cells;
  FluidOptions options;
  options.cell_size = h;
  options.density = 1;
  if (control) options.volume_control.emplace();
  const std::vector balls = {
      sphere({.centre = kMiddle, .edge_length = h, .exact_volume = 1}),
      sphere({.centre = kMiddle + Point(2.2, 0.5, 0), .edge_length = h, .exact_volume = 1})};
  const Triangles start = merged(balls);
  const Point velocity(1, 0.1, 0.05);
  Run run(
      start, h, options,
      [&](const Point& p) -> Point { return p[0] < 1.1 ? velocity : Point::Zero(); }, kPerFrame);
  const double ball = 4 * std::numbers::pi / 3, whole = volume(start);
  const std::string with = control ? "_controlled" : "";
  constexpr int kFrames = 40;
  for (int i = 1; i <= kFrames; ++i) {
    frame_of_equal_steps(run, 0.05);
    if (i % 2 != 0) continue;
    const LiquidMeasures now = run.fluid.measures();
    const double time = 0.05 * i;
    rows.add("_momentum_x" + with, cells, time, now.momentum[0], ball * velocity[0]);
    rows.add("_momentum_y" + with, cells, time, now.momentum[1], ball * velocity[1]);
    rows.add("_momentum_z" + with, cells, time, now.momentum[2], ball * velocity[2]);
    rows.add("_volume" + with, cells, time, run.volume(), whole);
    rows.add("_energy" + with, cells, time, now.kinetic_energy, ball * velocity.squaredNorm() / 2);
  }
  rows.add("_bodies" + with, cells, 0.05 * kFrames,
           static_cast<double>(components(run.surface->surface()).count), 1);
}

void meetings(Rows& rows) {
  for (const int cells : {6, 12})
    for (const bool control : {false, true}) {
      rows.restart();
      meeting(rows, cells, control);
    }
}

}  // namespace suture
