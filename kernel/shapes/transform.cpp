// Each transform refuses numbers that would leave a surface not finite or inside-out.
#include "kernel/shapes/transform.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "kernel/errors.h"

namespace suture {

Triangles translated(Triangles surface, const Point& by) {
  if (!by.allFinite()) throw InvalidInput("a translation must be finite; check its coordinates");
  for (Point& p : surface.positions) p += by;
  return surface;
}

Triangles scaled(Triangles surface, double factor) {
  return scaled(std::move(surface), Point::Constant(factor));
}

Triangles scaled(Triangles surface, const Point& factors) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::isfinite(factors[axis]) && factors[axis] > 0))
      throw InvalidInput("a scale factor is " + number(factors[axis]) +
                         "; it must be finite and positive, or the surface would be inside-out");
  for (Point& p : surface.positions) p = p.cwiseProduct(factors);
  return surface;
}

Triangles rotated(Triangles surface, const Point& axis, double angle) {
  const double length = axis.stableNorm();
  if (!(std::isfinite(length) && length > 0))
    throw InvalidInput("a rotation needs an axis that is finite and not zero");
  if (!std::isfinite(angle)) throw InvalidInput("a rotation needs a finite angle");
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis / length).toRotationMatrix();
  for (Point& p : surface.positions) p = turn * p;
  return surface;
}

Triangles merged(std::span<const Triangles> surfaces) {
  Triangles all;
  std::size_t vertices = 0, triangles = 0;
  for (const Triangles& s : surfaces) {
    vertices += s.positions.size();
    triangles += s.triangles.size();
  }
  if (vertices >= kNone)
    throw InvalidInput("the surfaces together have " + std::to_string(vertices) +
                       " vertices; an index holds at most " + std::to_string(kNone - 1) +
                       "; merge fewer or coarser surfaces");
  all.positions.reserve(vertices);
  all.triangles.reserve(triangles);
  for (const Triangles& s : surfaces) {
    const auto shift = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), s.positions.begin(), s.positions.end());
    for (const Triangle& t : s.triangles)
      all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return all;
}

}  // namespace suture
