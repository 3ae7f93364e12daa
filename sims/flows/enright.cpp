// LeVeque's three-dimensional vortex, reversed in time: the Enright test.
#include <cmath>
#include <numbers>

#include "sims/flows/fields.h"

namespace suture::sims {

VelocityField enright(const EnrightParameters& parameters) {
  constexpr double pi = std::numbers::pi;
  return [=](const Point& x, double t) -> Point {
    const double phase = pi * t / parameters.period;
    const double g =
        parameters.variant == EnrightVariant::leveque ? std::cos(phase) : std::sin(2 * phase);
    const Eigen::Array3d s = (pi * x.array()).sin(), s2 = (2 * pi * x.array()).sin();
    return g * Point(2 * s[0] * s[0] * s2[1] * s2[2], -s2[0] * s[1] * s[1] * s2[2],
                     -s2[0] * s2[1] * s[2] * s[2]);
  };
}

}  // namespace suture::sims
