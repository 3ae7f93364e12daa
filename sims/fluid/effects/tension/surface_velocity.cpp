// Values at the vertices of a surface, asked for at points near it.
#include "sims/fluid/effects/tension/surface_velocity.h"

#include <algorithm>
#include <array>
#include <limits>

namespace suture::sims {
namespace {

/// Weights of the corners at the triangle's point nearest to p.
Point weights_at(const Point& p, const std::array<Point, 3>& corner) {
  const Point u = corner[1] - corner[0], v = corner[2] - corner[0], w = p - corner[0];
  const Point normal = u.cross(v);
  if (const double n2 = normal.squaredNorm(); n2 > 0) {
    const double b = w.cross(v).dot(normal) / n2, c = u.cross(w).dot(normal) / n2;
    if (b >= 0 && c >= 0 && b + c <= 1) return {1 - b - c, b, c};
  }
  Point best = Point::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Point &from = corner[k], side = corner[(k + 1) % 3] - from;
    const double length2 = side.squaredNorm();
    const double along = length2 > 0 ? std::clamp((p - from).dot(side) / length2, 0.0, 1.0) : 0;
    const double distance2 = (p - from - along * side).squaredNorm();
    if (!(distance2 < least)) continue;
    least = distance2;
    best = Point::Zero();
    best[k] = 1 - along;
    best[(k + 1) % 3] = along;
  }
  return best;
}

}  // namespace

SurfacePlace nearest_place(const Triangles& surface, const NearestTriangle& nearest,
                           const Point& p) {
  const Triangle& t = surface.triangles[nearest.triangle(p)];
  return {t, weights_at(
                 p, {surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]})};
}

}  // namespace suture::sims
