// Liquid slides along solids and does not enter them.
#pragma once

#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/solids/solid_faces.h"

namespace suture::sims {

/// Gives each known closed face the velocity there without what differs from the solid's across its
/// surface, so that what is interpolated at a wall moves along it, and freely so [Batty et al.
/// 2007, §4; Bridson 2015, §5.4]. After extrapolate.
void constrain(MacVelocity& velocity, const SolidFaces& faces, const SolidsAt& solids);

/// The velocity of a body that moves as one.
struct BodyVelocity {
  Point velocity;
  bool squeezed = false;  ///< there is no way for all its points: with this some are in a solid
};

/// Takes from velocities, from t to t + dt, what would lead into solids. Only the part across the
/// solid's surface changes. What is inside at t is outside at t + dt, if there is a way: where
/// solids overlap it ends half way between their sides.
struct WallProjection {
  const Solids& solids;
  double t = 0, dt = 0;
  double length = 0;  ///< of the scene's detail, e.g. h, over which the solid's normal is taken

  /// v of a point p, changed.
  Point of_point(const Point& p, const Point& v) const;
  /// v of all points of a body, changed for all of them alike.
  BodyVelocity of_body(const std::vector<Point>& body, const Point& v) const;
};

}  // namespace suture::sims
