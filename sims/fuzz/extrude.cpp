// Frames follow the polyline without twisting more than they must; where it turns back they may
// collapse.
#include "sims/fuzz/extrude.h"

#include <cmath>
#include <numbers>

namespace suture::sims {

Triangles extrude(const std::vector<std::vector<Point>>& stations, Ends ends) {
  Triangles surface;
  const auto sides = static_cast<std::uint32_t>(stations.front().size());
  const auto count = static_cast<std::uint32_t>(stations.size());
  for (const auto& station : stations)
    surface.positions.insert(surface.positions.end(), station.begin(), station.end());
  const std::uint32_t walls = ends == Ends::joined ? count : count - 1;
  for (std::uint32_t s = 0; s < walls; ++s)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t here = s * sides, there = (s + 1) % count * sides, l = (k + 1) % sides;
      surface.triangles.push_back({here + k, here + l, there + l});
      surface.triangles.push_back({here + k, there + l, there + k});
    }
  if (ends == Ends::joined) return surface;
  const std::uint32_t last = (count - 1) * sides;
  for (std::uint32_t k = 1; k + 1 < sides; ++k) {
    surface.triangles.push_back({0, k + 1, k});
    surface.triangles.push_back({last, last + k, last + k + 1});
  }
  return surface;
}

namespace {

Point direction(const Point& from, const Point& to) {
  const Point ahead = to - from;
  return ahead.norm() > 0 ? Point(ahead.normalized()) : Point(0, 0, 1);
}

/// A unit vector across `ahead`, and across `up` where that has another direction.
Point across(const Point& ahead, const Point& up) {
  Point right = ahead.cross(up);
  if (!(right.norm() > 0)) right = ahead.cross(Point(1, 0, 0));
  if (!(right.norm() > 0)) right = ahead.cross(Point(0, 1, 0));
  return right.normalized();
}

}  // namespace

Triangles tube(const std::vector<Point>& middle, const TubeShape& shape) {
  const std::size_t n = middle.size();
  const bool ring = shape.ends == Ends::joined;
  Point up = Point(0.36, 0.48, 0.8);
  std::vector<std::vector<Point>> stations;
  for (std::size_t s = 0; s < n; ++s) {
    const Point& before = middle[s > 0 ? s - 1 : (ring ? n - 1 : 0)];
    const Point& after = middle[s + 1 < n ? s + 1 : (ring ? 0 : n - 1)];
    const Point ahead = direction(before, after), right = across(ahead, up);
    up = right.cross(ahead);  // right × up = ahead turned: counter-clockwise below
    auto& station = stations.emplace_back();
    for (int k = 0; k < shape.sides; ++k) {
      const double angle = -2 * std::numbers::pi * k / shape.sides;
      station.push_back(middle[s] +
                        shape.radius * (std::cos(angle) * right + std::sin(angle) * up));
    }
  }
  return extrude(stations, shape.ends);
}

}  // namespace suture::sims
