// Liquid slides along solids and does not enter them.
#pragma once

#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/solids/solids.h"

namespace suture::sims {

/// Gives each known closed face the velocity there without what differs from the solid's across its
/// surface, so that what is interpolated at a wall moves along it, and freely so [Batty et al.
/// 2007, §4; Bridson 2015, §5.4]. After extrapolate.
void constrain(MacVelocity& velocity, const SolidFaces& faces, const Solids& solids, double t);

/// Velocity v of a point p from t to t + dt, changed so that a p outside of the solids does not
/// enter them, and one inside is outside by then, if there is a way: where solids overlap it ends
/// half way between their sides. Only the part across the solid's surface changes. `length`: that
/// of the scene's detail, e.g. h, over which the solid's normal is taken.
Point kept_out(const Solids& solids, const Point& p, const Point& v, double t, double dt,
               double length);

/// The same for the points of a body that moves as one.
struct KeptBody {
  Point velocity;
  bool squeezed = false;  ///< there is no way for all its points: with this some are in a solid
};
KeptBody kept_out(const Solids& solids, const std::vector<Point>& body, const Point& v, double t,
                  double dt, double length);

}  // namespace suture::sims
