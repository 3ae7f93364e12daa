// Fans for convex polygons; ear cutting with exact orientations for the others.
#include "kernel/formats/polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>

namespace suture {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Flat = Kernel::Point_2;

// Cutting ears takes quadratic time; what has more corners is a convex cap, or no real mesh.
constexpr std::size_t kMostEars = 2000;

struct Corner2 {
  std::uint32_t vertex;
  Flat at;
};

Point normal(const Point& a, const Point& b, const Point& c) { return (b - a).cross(c - a); }

Point whole_normal(const std::vector<Point>& at, std::span<const std::int64_t> corners) {
  Point sum = Point::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += normal(at[corners[0]], at[corners[i]], at[corners[i + 1]]);
  return sum;
}

bool covers(const Corner2& a, const Corner2& b, const Corner2& c, const Flat& p) {
  if (p == a.at || p == b.at || p == c.at) return false;
  return CGAL::orientation(a.at, b.at, p) != CGAL::RIGHT_TURN &&
         CGAL::orientation(b.at, c.at, p) != CGAL::RIGHT_TURN &&
         CGAL::orientation(c.at, a.at, p) != CGAL::RIGHT_TURN;
}

bool is_ear(const std::vector<Corner2>& left, std::size_t i) {
  const std::size_t n = left.size();
  const Corner2 &a = left[(i + n - 1) % n], &b = left[i], &c = left[(i + 1) % n];
  if (CGAL::orientation(a.at, b.at, c.at) != CGAL::LEFT_TURN) return false;
  for (const Corner2& other : left)
    if (covers(a, b, c, other.at)) return false;
  return true;
}

}  // namespace

void triangulate_polygon(const std::vector<Point>& positions, std::span<const std::int64_t> corners,
                         std::vector<Triangle>& triangles) {
  const auto v = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
  const Point whole = whole_normal(positions, corners);
  bool fan = true;
  for (std::size_t i = 1; i + 1 < corners.size() && fan; ++i)
    fan = normal(positions[v(0)], positions[v(i)], positions[v(i + 1)]).dot(whole) > 0;
  if (corners.size() == 3 || fan || corners.size() > kMostEars || !whole.allFinite()) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      triangles.push_back({v(0), v(i), v(i + 1)});
    return;
  }
  int drop = 0;
  whole.cwiseAbs().maxCoeff(&drop);
  const int x = whole[drop] > 0 ? (drop + 1) % 3 : (drop + 2) % 3, y = 3 - drop - x;
  std::vector<Corner2> left;
  for (std::size_t i = 0; i < corners.size(); ++i)
    left.push_back({v(i), Flat(positions[v(i)][x], positions[v(i)][y])});
  while (left.size() >= 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !is_ear(left, ear)) ++ear;
    if (ear == left.size()) ear = 0;  // no simple polygon: any triangle is as good
    const std::size_t n = left.size();
    triangles.push_back(
        {left[(ear + n - 1) % n].vertex, left[ear].vertex, left[(ear + 1) % n].vertex});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
}

}  // namespace suture
