// The Lagrangian update: vertices carried through a velocity field by RK4 [§4].
#pragma once

#include "surgery/tracker.h"

namespace suture::surgery {

/// Positions after one step of the classic Runge–Kutta method of order 4 from t to t + dt.
std::vector<Point> advected(const std::vector<Point>& positions, const VelocityField& u, double t,
                            double dt);

}  // namespace suture::surgery
