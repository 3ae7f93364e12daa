// A compression that folds a sheet, with a wave that travels with the material.
#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "sims/flows/fields.h"

namespace suture::sims {

VelocityField fold(const FoldParameters& parameters) {
  constexpr double right_angle = 1e-9;  // cosine: what rounding leaves of one, with room
  if (!(parameters.axis.norm() > 0) || !(parameters.up.norm() > 0) ||
      std::abs(parameters.axis.normalized().dot(parameters.up.normalized())) > right_angle)
    throw InvalidInput("a fold's axis and up must be two directions at right angles");
  const Point axis = parameters.axis.normalized(), up = parameters.up.normalized();
  const Point centre = parameters.centre;
  const double rate = parameters.rate, amplitude = parameters.amplitude;
  const double wave_number = 2 * std::numbers::pi / parameters.wavelength;
  return [=](const Point& x, double t) -> Point {
    const double s = axis.dot(x - centre);
    const double wave = amplitude * std::cos(wave_number * std::exp(rate * t) * s);
    const Point across = x - centre - s * axis;
    return rate * (0.5 * across - s * axis) + wave * up;
  };
}

}  // namespace suture::sims
