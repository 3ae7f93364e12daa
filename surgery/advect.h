// The Lagrangian update: vertices carried through a velocity field by RK4 [§4].
#pragma once

#include <functional>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// u(x, t): velocity at a point and a time, in the scene's units.
using VelocityField = std::function<Point(const Point&, double)>;

namespace surgery {

/// A step of time from `start` to start + length.
struct TimeStep {
  double start, length;
};

/// Positions after one step of the classic Runge–Kutta method of order 4.
std::vector<Point> advected(const std::vector<Point>& positions, const VelocityField& u,
                            const TimeStep& step);

}  // namespace surgery

}  // namespace suture
