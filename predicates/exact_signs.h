// Exact signs without any shift, for questions that a floating-point filter could not decide.
#pragma once

#include "kernel/triangles.h"

namespace suture {

/// Sign of the determinant |q−p, r−p| of points (x, y). \pre finite
int exact_orientation(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r);

/// Sign of (b−a)×(c−a)·(d−a). \pre finite
int exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace suture
