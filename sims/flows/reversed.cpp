// Flows that are simple in themselves, and any flow forth and back.
#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "sims/flows/fields.h"

namespace suture::sims {

VelocityField translation(const Point& velocity) {
  return [velocity](const Point&, double) -> Point { return velocity; };
}

VelocityField vortex() {
  constexpr double pi = std::numbers::pi;
  return [](const Point& x, double) -> Point {
    const double sx = std::sin(pi * x[0]), sy = std::sin(pi * x[1]);
    return {sx * sx * std::sin(2 * pi * x[1]), -sy * sy * std::sin(2 * pi * x[0]), 0};
  };
}

VelocityField reversed(VelocityField u, double time) {
  if (!(time > 0)) throw InvalidInput("a flow is reversed over a time above zero");
  return [u = std::move(u), time](const Point& x, double t) -> Point {
    const double phase = std::numbers::pi * t / time;
    return std::cos(phase) * u(x, std::sin(phase) * time / std::numbers::pi);
  };
}

}  // namespace suture::sims
