// Rigid rotation about an axis: Zalesak's field, and any other.
#include "kernel/errors.h"
#include "sims/flows/fields.h"

#include <Eigen/Geometry>

namespace suture::sims {

VelocityField rotation(const RotationParameters& parameters) {
  if (!(parameters.axis.norm() > 0))
    throw InvalidInput("a rotation's axis has no direction; give a vector other than zero");
  const Point omega = parameters.rate * parameters.axis.normalized();
  const Point centre = parameters.centre;
  return [=](const Point& x, double) -> Point { return omega.cross(x - centre); };
}

}  // namespace suture::sims
