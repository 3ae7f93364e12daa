// Paths through a velocity field, by Runge–Kutta steps of order 2 to 4, in cells of a grid.
#pragma once

#include "surgery/tracker.h"

namespace suture::sims {

/// The field u as the grid sees it: points are in cells from its origin, velocities in cells a unit
/// of time.
struct GridVelocity {
  const VelocityField& u;
  Point origin;
  double cell_size;

  Point operator()(const Point& p, double t) const {
    return u(origin + cell_size * p, t) / cell_size;
  }
};

/// A step along paths, from `time` to time + dt. Order 2 is the midpoint rule, 3 the TVD scheme of
/// Shu and Osher 1988, 4 the classic one.
struct PathStep {
  double time = 0, dt = 0;  ///< dt < 0 goes back
  int order = 2;

  PathStep back() const { return {time + dt, -dt, order}; }
};

/// The place, after the step, of a particle that is at `p` before it. \pre 2 ≤ order ≤ 4
inline Point path_end(const GridVelocity& u, const Point& p, const PathStep& step) {
  const auto& [t, dt, order] = step;
  const Point a = u(p, t);
  if (order == 2) return p + dt * u(p + dt / 2 * a, t + dt / 2);
  if (order == 3) {
    const Point first = p + dt * a;
    const Point second = 0.75 * p + 0.25 * (first + dt * u(first, t + dt));
    return p / 3 + 2.0 / 3 * (second + dt * u(second, t + dt / 2));
  }
  const Point b = u(p + dt / 2 * a, t + dt / 2);
  const Point c = u(p + dt / 2 * b, t + dt / 2);
  const Point d = u(p + dt * c, t + dt);
  return p + dt / 6 * (a + 2 * b + 2 * c + d);
}

}  // namespace suture::sims
