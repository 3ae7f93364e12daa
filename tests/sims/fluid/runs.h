// A surface and the liquid in it, stepped together: for what is measured of the whole fluid.
#pragma once

#include <algorithm>
#include <memory>
#include <numbers>
#include <utility>

#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/driver/driver.h"
#include "sims/fluid/fluid.h"
#include "sims/tracking/mesh_tracker.h"
#include "tests/sims/fluid/blobs.h"
#include "tests/sims/fluid/drops.h"

namespace suture {

using namespace suture::sims;

/// How the mesh is looked after: never, or at the end of each frame.
inline constexpr Schedule kMarkers{0, 0, 0}, kPerFrame{1, 1, 1};

inline Point at_rest(const Point&) { return Point::Zero(); }

inline SolidOptions container(const Point& low, const Point& high) {
  SolidOptions s;
  s.box = {low, high};
  return s;
}

/// A block of liquid between two corners, on which its vertices are to the last bit.
inline Triangles block(const Point& low, const Point& high, double edge) {
  Triangles made = box({.centre = (low + high) / 2, .size = high - low, .edge_length = edge});
  for (Point& p : made.positions)
    for (int a = 0; a < 3; ++a)
      for (const double wall : {low[a], high[a]})
        if (std::abs(p[a] - wall) < 1e-9 * (high[a] - low[a])) p[a] = wall;
  return made;
}

struct Run {
  std::unique_ptr<SurfaceTracker> surface;
  Fluid fluid;
  Schedule schedule;

  Run(const Triangles& start, double cell, const FluidOptions& options, Fluid::Initial initial,
      const Schedule& looked_after)
      : fluid(options, std::move(initial)), schedule(looked_after) {
    TrackerOptions tracker;
    tracker.cell_size = cell;
    tracker.origin = Point(0.011, 0.013, 0.007) * cell;
    tracker.quality.keep_features = false;
    tracker.quality.subdivision = Subdivision::fitted;
    surface = make_mesh_tracker(start, tracker);
  }
  void frame(double dt) {
    StepWatcher nobody;
    Driver(*surface, fluid, schedule).frame(fluid.time() + dt, nobody);
  }
  const std::vector<Point>& points() { return surface->surface().positions; }
  double volume() { return suture::volume(surface->surface()); }
  double fastest() {
    double most = 0;
    for (const Point& p : points()) most = std::max(most, fluid.velocity(p).norm());
    return most;
  }
};

// --- Drops under tension: tension, density and cells are 1

inline FluidOptions drop_options() {
  FluidOptions options;
  options.cell_size = options.density = 1;
  options.surface_tension = 1;
  options.pressure.tolerance = 1e-8;
  return options;
}

/// The period of the second mode [Lamb 1932, §275].
inline double drop_period(double radius) {
  return 2 * std::numbers::pi * std::sqrt(radius * radius * radius / 8);
}

// --- A ball of radius 1 that is twisted: a wave that its free surface reflects

inline const Point kMiddle{0.013, 0.027, -0.017};  // nowhere special on the grid
inline constexpr double kFree = 5.763459197;       // k·R of the slowest torsion without a torque

inline Point twist(const Point& p) { return torsion(kFree)(p); }

/// The part of `size` times the twist in the liquid of the ball about `middle` that moves with
/// `drift`, and the root of the mean square of what is else, relative to the twist's.
inline std::pair<double, double> twisted(const Fluid& fluid, double size, const Point& middle,
                                         const Point& drift) {
  double part = 0, all = 0, rest = 0;
  Random random(5);
  std::vector<std::pair<Point, Point>> samples;
  while (samples.size() < 2000) {
    const Point p = random_vector(random);
    if (p.norm() > 1) continue;
    samples.emplace_back(twist(p), (fluid.velocity(middle + p) - drift) / size);
    part += samples.back().first.dot(samples.back().second);
    all += samples.back().first.squaredNorm();
  }
  for (const auto& [should, is] : samples) rest += (is - should).squaredNorm();
  return {part / all, std::sqrt(rest / all)};
}

inline Run twisted_ball(int cells, double size, FluidOptions options,
                        const Point& drift = Point::Zero(), double tolerance = 1e-8) {
  options.cell_size = 1.0 / cells;
  options.density = 1;
  options.pressure.tolerance = options.viscous_solver.tolerance = tolerance;
  return {sphere({.centre = kMiddle, .edge_length = 0.9 / cells, .exact_volume = 1}), 1.0 / cells,
          options, [=](const Point& p) -> Point { return drift + size * twist(p - kMiddle); },
          kMarkers};
}

/// The largest strain on the way of a ball of modulus 1 that is set turning by `size` times the
/// twist, and the one that is left when friction has brought it to rest: sizes of the deviatoric
/// strain as an elastic ball's would be, where it is largest. Without what it goes on to turn as a
/// whole, which nothing stops.
inline std::pair<double, double> lasting_strain(int cells, double size, double yield_strain) {
  constexpr double kOfTwist = kFree * 0.30675 / std::numbers::sqrt2;  // k·max j₂/√2
  constexpr int kSteps = 60;
  FluidOptions options;
  options.viscosity = 0.1;
  options.viscoelasticity = ElasticOptions{.modulus = 1, .yield_strain = yield_strain};
  Run run = twisted_ball(cells, size, options, Point::Zero(), 1e-5);
  const double dt = 0.5 / cells;
  std::vector<double> twists{0};
  for (int i = 0; i < kSteps; ++i) {
    run.fluid.step(*run.surface, dt);
    twists.push_back(twists.back() +
                     dt * size * twisted(run.fluid, size, kMiddle, Point::Zero()).first);
  }
  const double still_turns = twists[kSteps] - twists[kSteps - 1];
  double most = 0;
  for (int i = 0; i <= kSteps; ++i) most = std::max(most, twists[i] - i * still_turns);
  return {kOfTwist * most, kOfTwist * (twists[kSteps] - kSteps * still_turns)};
}

// --- A vortex that fills [0, π]² and some cells across it [Taylor and Green 1937]

inline Point vortex(const Point& p) {
  return {std::sin(p[0]) * std::cos(p[1]), -std::cos(p[0]) * std::sin(p[1]), 0};
}

struct Vortex {
  int cells;
  double size;  ///< of its velocity
  Run run;

  static Run started(int cells, double size, FluidOptions options) {
    const double h = std::numbers::pi / cells;
    const Point low = Point::Zero(), high = h * Point(cells, cells, 3);
    options.cell_size = h;
    options.density = 1;
    options.no_slip = false;
    options.pressure.tolerance = options.viscous_solver.tolerance = 1e-9;
    options.solids = {container(low, high)};
    return {block(low, high, h), h, options,
            [size](const Point& p) -> Point { return size * vortex(p); }, kMarkers};
  }
  Vortex(int n, double speed, const FluidOptions& options)
      : cells(n), size(speed), run(started(n, speed, options)) {}

  /// Components at the inner faces across x and y, over `size`: is, should.
  std::vector<std::pair<double, double>> faces() const {
    const double h = std::numbers::pi / cells;
    std::vector<std::pair<double, double>> all;
    for (int i = 1; i < cells; ++i)
      for (int j = 0; j < cells; ++j)
        for (int a = 0; a < 2; ++a) {
          Point p = h * Point(i, j + 0.5, 1.5);
          if (a == 1) std::swap(p[0], p[1]);
          all.emplace_back(run.fluid.velocity(p)[a] / size, vortex(p)[a]);
        }
    return all;
  }
  void advance(double time, int steps) {
    for (int i = 0; i < steps; ++i) run.fluid.step(*run.surface, time / steps);
  }
  /// The part of the vortex, and the root of the mean square of what else there is, relative.
  std::pair<double, double> part() const {
    double dot = 0, all = 0, rest = 0;
    for (const auto& [is, should] : faces()) {
      dot += is * should;
      all += should * should;
      rest += (is - should) * (is - should);
    }
    return {dot / all, std::sqrt(rest / all)};
  }
};

// --- A column of water, 1 wide and n² high, in a tank some cells deep; g = 1 and density 1

inline FluidOptions dam_options(int n2, int cells, int deep) {
  FluidOptions options;
  options.cell_size = 1.0 / cells;
  options.density = 1;
  options.gravity = {0, -1, 0};
  options.volume_control.emplace();
  options.solids = {container({0, 0, 0}, {12, n2 + 2.0, deep * options.cell_size})};
  return options;
}

inline Run dam_run(int n2, const FluidOptions& options, int deep) {
  const double h = options.cell_size;
  return {block({0, 0, 0}, {1, 1.0 * n2, deep * h}, h), h, options, at_rest, kPerFrame};
}

/// The acceleration at which its surface falls along the wall when it is let go, over g.
inline double fall_at_wall(int n2, int cells) {
  constexpr double kStep = 1e-3;
  Run run = dam_run(n2, dam_options(n2, cells, 3), 3);
  run.fluid.step(*run.surface, kStep);
  return -run.fluid.velocity({0, 1.0 * n2, 1.5 / cells})[1] / (kStep / 2);
}

/// The same by the series that solves for its pressure: Laplace's equation, 0 at its free sides,
/// weight at its foot [as Stoker 1957, §12.1].
inline double exact_fall_at_wall(int n2) {
  double fall = 1;
  for (int k = 0; k < 20; ++k) {
    const double wave = (k + 0.5) * std::numbers::pi;
    fall -= (k % 2 == 0 ? 2 : -2) / (wave * std::cosh(wave * n2));
  }
  return fall;
}

// --- A column of thick liquid, 1 high, that a plate presses on a floor

struct PressedColumn {
  static constexpr double kSpeed = 0.1;  ///< of the plate: viscosity is all that resists
  double width, bend;                    ///< bend: of its middle, to begin with
  Run run;

  static Run started(double cell, double width, double bend) {
    FluidOptions options;
    options.cell_size = cell;
    options.density = 1;
    options.viscosity = 0.01 / std::pow(width, 4);  // inertia is a hundredth of what resists
    options.volume_control.emplace();
    SolidOptions plate;
    plate.kind = SolidKind::box;
    plate.box = {{-1, 1, -1}, {1, 1.5, 1}};
    plate.motion.velocity = {0, -kSpeed, 0};
    options.solids = {container({-1, 0, -1}, {1, 2, 1}), plate};
    const double side = width / 2;
    Triangles column = block({-side, 0, -side}, {side, 1, side}, 0.9 * cell);
    for (Point& p : column.positions)
      p[0] += bend * (1 - std::cos(2 * std::numbers::pi * p[1])) / 2;
    return {column, cell, options, at_rest, kPerFrame};
  }
  explicit PressedColumn(double cell, double wide = 0.1, double bent = 0.004)
      : width(wide), bend(bent), run(started(cell, wide, bent)) {}

  double height() const { return 1 - kSpeed * run.fluid.time(); }
  /// How far the middle's slice, a cell or two high, is aside.
  double aside() {
    double least = 1, most = -1;
    for (const Point& p : run.points()) {
      if (std::abs(p[1] - height() / 2) > 0.02) continue;
      least = std::min(least, p[0]);
      most = std::max(most, p[0]);
    }
    return (least + most) / 2;
  }
  /// The growth of bend in Euler's column between clamps, where viscosity stands for elasticity and
  /// shortening for time: d(ln aside) is 12/(2π)²·(height/width)² of d(ln height).
  double slender() const {
    const double per = 3 / (std::numbers::pi * std::numbers::pi * width * width);
    return bend * std::exp(per * (1 - std::pow(height(), 3)) / 3);
  }
};

}  // namespace suture
