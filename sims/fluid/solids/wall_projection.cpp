// Liquid slides along solids and does not enter them.
#include "sims/fluid/solids/wall_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace suture::sims {
namespace {

/// Differences for a normal are taken over this part of a length: short beside what a solid's shape
/// changes over, long beside rounding.
constexpr double kNormalStep = 1e-3;

/// A face deeper in a solid than this, in cells, takes the solid's own velocity: what is asked for
/// outside of a solid does not meet it.
constexpr double kDeepest = 2;

/// A corner takes a push out of each of its sides, and one more for rounding.
constexpr int kMostPushes = 4;

/// The parts of a path: a vertex crosses at most half the scene's detail between two looks.
constexpr double kParts = 2;
constexpr int kMostParts = 64;

int parts_of(double way, double length) {
  return static_cast<int>(
      std::clamp(std::ceil(kParts * way / length), 1.0, static_cast<double>(kMostParts)));
}

Point across(const Point& v, const Point& normal) { return normal * v.dot(normal); }

}  // namespace

void constrain(MacVelocity& velocity, const SolidFaces& faces, const SolidsAt& solids) {
  if (!faces.any()) return;
  const SparseGrid& grid = *velocity.grid;
  const double h = grid.h();
  std::array<std::vector<double>, 3> changed;
  std::array<std::vector<Slot>, 3> where;
  for (int axis = 0; axis < 3; ++axis)
    for (Slot s = 0; s < grid.size(); ++s) {
      if (faces.open[axis][s] > 0 || velocity.known[axis][s] == 0) continue;
      const Point p = grid.face(grid.cell(s), axis);
      const double depth = std::max(0.0, -solids.distance(p));
      const Point normal = solids.normal(p, kNormalStep * h), own = solids.velocity(p);
      double u = own[axis];
      if (depth <= kDeepest * h) {
        // Across the wall linear from the liquid through the solid's at its surface. The place in
        // the liquid is so far off that, at a wall along the grid, no closed face has a part in it.
        const double off = std::max(h, 2 * depth);
        const Point v = velocity.at(p + off * normal, own);
        u = (v - off / (off - depth) * across(v - own, normal))[axis];
      }
      changed[axis].push_back(u);
      where[axis].push_back(s);
    }
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t n = 0; n < where[axis].size(); ++n)
      velocity.u[axis][where[axis][n]] = changed[axis][n];
}

Point WallProjection::of_point(const Point& p, const Point& v) const {
  if (!solids.any() || !(dt > 0)) return v;
  const double way = (v.norm() + solids.fastest()) * dt;
  if (solids.distance(p, t) > way) return v;
  const int parts = parts_of(way, length);
  Point q = p, before = p;
  bool pushed = false;
  for (int part = 1; part <= parts; ++part) {
    q += v * (dt / parts);
    const double now = t + dt * part / parts;
    for (int n = 0; n < kMostPushes; ++n) {
      const double d = solids.distance(q, now);
      if (d >= 0) break;
      before = q;
      q -= d * solids.normal(q, now, kNormalStep * length);
      pushed = true;
    }
  }
  if (!pushed) return v;
  // Solids that leave no room push it from one's side to the other's: all such points meet in the
  // middle, and what was between the solids is squeezed to nothing.
  if (solids.distance(q, t + dt) < -kNormalStep * length) q = (q + before) / 2;
  return (q - p) / dt;
}

BodyVelocity WallProjection::of_body(const std::vector<Point>& body, const Point& v) const {
  if (!solids.any() || !(dt > 0) || body.empty()) return {v};
  const int parts = parts_of((v.norm() + solids.fastest()) * dt, length);
  Point gone = Point::Zero();
  const auto deepest = [&](double now) {
    std::pair<double, Point> found{std::numeric_limits<double>::infinity(), body.front()};
    for (const Point& p : body)
      if (const double d = solids.distance(p + gone, now); d < found.first) found = {d, p + gone};
    return found;
  };
  bool pushed = false;
  for (int part = 1; part <= parts; ++part) {
    gone += v * (dt / parts);
    const double now = t + dt * part / parts;
    for (int n = 0; n < kMostPushes; ++n) {
      const auto [d, q] = deepest(now);
      if (d >= 0) break;
      gone -= d * solids.normal(q, now, kNormalStep * length);
      pushed = true;
    }
  }
  if (!pushed) return {v};
  return {gone / dt, deepest(t + dt).first < -kNormalStep * length};
}

}  // namespace suture::sims
