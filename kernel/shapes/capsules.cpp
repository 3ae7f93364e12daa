// A smooth union of tapered capsules, and its surface: what animals and hands are made of.
#include "kernel/shapes/capsules.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "kernel/isosurface/isosurface.h"
#include "kernel/shapes/relax.h"

namespace suture {
namespace {

using Value = CapsuleUnion::Value;

// Near enough to a distance: to the ball of the nearest point of the segment.
Value distance(const Capsule& c, const Point& p) {
  const Point along = c.end - c.start;
  const double length2 = along.squaredNorm(), at = (p - c.start).dot(along) / length2;
  const double t = std::clamp(at, 0.0, 1.0);
  const Point away = p - c.start - t * along;
  const double d = away.norm();
  Point gradient = away / std::max(d, 1e-300);
  if (t == at) gradient -= (c.to - c.from) / length2 * along;
  return {d - (c.from + t * (c.to - c.from)), gradient};
}

// The minimum, rounded where the two are within `width` of each other (Quilez's polynomial).
Value smooth_minimum(const Value& a, const Value& b, double width) {
  const Value &low = a.value < b.value ? a : b, &high = a.value < b.value ? b : a;
  const double h = std::max(width - (high.value - low.value), 0.0) / width;
  return {low.value - h * h * width / 4, low.gradient + h / 2 * (high.gradient - low.gradient)};
}

}  // namespace

CapsuleUnion::Value CapsuleUnion::at(const Point& p) const {
  Value value = distance(capsules_[0], p);
  for (std::size_t i = 1; i < capsules_.size(); ++i)
    value = smooth_minimum(value, distance(capsules_[i], p), round_);
  return value;
}

Point CapsuleUnion::onto_surface(Point p) const {
  constexpr int kNewtonSteps = 4;  // from within half a cell; then at the size of rounding
  for (int k = 0; k < kNewtonSteps; ++k) {
    const Value v = at(p);
    p -= v.value / v.gradient.squaredNorm() * v.gradient;
  }
  return p;
}

Triangles skin(const CapsuleUnion& capsules, const SkinOptions& options) {
  constexpr double kCellsPerEdge = 1.9;  // measured: gives edges of edge_length on average
  constexpr double kLeastCosine = 0.3;   // between a triangle and the surface's normal
  const double cell = kCellsPerEdge * (options.edge_length / options.length);
  const Point margin = Point::Constant(0.06 + 2 * cell);
  Triangles surface = isosurface([&](const Point& q) { return capsules.at(q).value; },
                                 {options.box.low - margin, options.box.high + margin}, cell);
  relax(surface.positions, surface.triangles,
        {2, 15, [&](const Point& q) { return capsules.onto_surface(q); },
         [&](const Point& a, const Point& b, const Point& c) {
           const Point normal = (b - a).cross(c - a), up = capsules.at((a + b + c) / 3).gradient;
           return normal.dot(up) > kLeastCosine * normal.norm() * up.norm();
         }});
  for (Point& q : surface.positions) q = options.centre + options.length * q;
  return surface;
}

}  // namespace suture
