// A stretch that pinches: two ends pulled apart, and the neck between them thinned.
#include <cmath>

#include "kernel/errors.h"
#include "sims/flows/fields.h"

namespace suture::sims {

VelocityField stretch(const StretchParameters& parameters) {
  if (!(parameters.axis.norm() > 0))
    throw InvalidInput("a stretch's axis has no direction; give a vector other than zero");
  const Point axis = parameters.axis.normalized(), centre = parameters.centre;
  const double rate = parameters.rate, width = parameters.width;
  return [=](const Point& x, double) -> Point {
    const double s = axis.dot(x - centre);
    const Point across = x - centre - s * axis;
    if (width <= 0) return rate * (s * axis - 0.5 * across);
    const double g = std::tanh(s / width);
    return rate * (width * g * axis - 0.5 * (1 - g * g) * across);
  };
}

}  // namespace suture::sims
