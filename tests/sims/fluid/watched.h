// A fluid in a coarse tank, watched frame by frame.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/driver/driver.h"
#include "sims/fluid/fluid.h"
#include "sims/tracking/mesh_tracker.h"

namespace suture {

using namespace suture::sims;

inline constexpr double kTankCell = 0.125;

inline SolidOptions solid(SolidKind kind, const Point& low, const Point& high,
                          const Point& velocity = Point::Zero()) {
  SolidOptions s;
  s.kind = kind;
  s.box = {low, high};
  s.motion.velocity = velocity;
  return s;
}

/// The fluid's options, in a tank of 1 × 1 × 0.5.
inline FluidOptions tank() {
  FluidOptions o;
  o.cell_size = kTankCell;
  o.gravity = {0, -10, 0};
  o.solids = {solid(SolidKind::container, {0, 0, 0}, {1, 1, 0.5})};
  return o;
}

inline Triangles block(const Point& low, const Point& high) {
  return box({.centre = (low + high) / 2, .size = high - low, .edge_length = kTankCell});
}

/// Its energy is density · 10 · volume · 0.3 = 360, of which the grid sees up to 3 % more.
inline constexpr double kVolume = 0.12, kEnergy = 360;
inline Triangles column() { return block({0, 0, 0}, {0.4, 0.6, 0.5}); }

inline Triangles ball_of(double radius, const Point& centre = {0.5, 0.5, 0.25}) {
  return sphere({.centre = centre, .radius = radius, .edge_length = std::min(radius, kTankCell)});
}

/// Runs frame by frame; each surgery has to leave a closed manifold of finite numbers.
struct Watched : StepWatcher {
  std::unique_ptr<SurfaceTracker> surface;
  Fluid fluid;
  double start;            ///< volume
  double most_energy = 0;  ///< kinetic and potential, of ends of frames
  double fastest = 0;
  int frames = 0, steps = 0;

  /// `finer`: cells of the surface's lattice in one of the grid.
  explicit Watched(const Triangles& liquid, const FluidOptions& options,
                   const Point& velocity = Point::Zero(), double finer = 1)
      : Watched(
            liquid, options, [=](const Point&) { return velocity; }, finer) {}

  Watched(const Triangles& liquid, const FluidOptions& options, Fluid::Initial initial,
          double finer = 1)
      : fluid(options, std::move(initial)), start(volume(liquid)) {
    TrackerOptions tracker;
    tracker.cell_size = options.cell_size / finer;
    tracker.origin = Point(0.011, 0.013, 0.007) * options.cell_size;
    tracker.quality.keep_features = false;
    surface = make_mesh_tracker(liquid, tracker);
  }

  void run(int count, double dt) {
    Driver driver(*surface, fluid, {1, 1, 1});
    for (int i = 0; i < count; ++i, ++frames) {
      driver.frame(fluid.time() + dt, *this);
      look();
    }
  }
  void moved(double /*dt*/) override { ++steps; }
  void look() {
    const Audit found = audit(surface->surface());
    CAPTURE(frames, found.first);
    REQUIRE(found.closed_manifold());
    for (const Point& p : surface->surface().positions) REQUIRE(fluid.velocity(p).allFinite());
    const LiquidMeasures now = fluid.measures();
    REQUIRE(std::isfinite(now.kinetic_energy + now.potential_energy));
    most_energy = std::max(most_energy, now.kinetic_energy + now.potential_energy);
    fastest = std::max(fastest, now.largest_velocity);
  }
  double left() const { return volume(surface->surface()) / start; }  ///< of what there was
  Point middle() const {
    Point sum = Point::Zero();
    const std::vector<Point>& all = surface->surface().positions;
    for (const Point& p : all) sum += p / static_cast<double>(all.size());
    return sum;
  }
  double lowest() const {
    double y = 1e9;
    for (const Point& p : surface->surface().positions) y = std::min(y, p[1]);
    return y;
  }
};

#define SEE(w) CAPTURE((w).most_energy, (w).fastest, (w).left(), (w).steps)

}  // namespace suture
