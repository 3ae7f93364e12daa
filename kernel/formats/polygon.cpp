// Fans for convex polygons; ear cutting with exact orientations for the others.
#include "kernel/formats/polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>

namespace suture {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Flat = Kernel::Point_2;

// A polygon with more corners is a convex cap, or no real mesh.
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

// A polygon from which ears are cut. Whether a corner is an ear is asked again only where a cut
// changed its neighbours, so that all cuts together take quadratic time, whatever the polygon.
class Ears {
 public:
  explicit Ears(std::vector<Corner2> corners) : left_(std::move(corners)) {
    for (std::size_t i = 0; i < left_.size(); ++i) ear_.push_back(is_ear(i));
  }
  std::size_t size() const { return left_.size(); }

  Triangle cut() {
    std::size_t i = 0;
    while (i < size() && !ear_[i]) ++i;
    if (i == size()) i = 0;  // no simple polygon: any triangle is as good
    const Triangle t{left_[before(i)].vertex, left_[i].vertex, left_[after(i)].vertex};
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
    ear_.erase(ear_.begin() + static_cast<std::ptrdiff_t>(i));
    const std::size_t next = i % size(), last = before(next);
    ear_[last] = is_ear(last);
    ear_[next] = is_ear(next);
    return t;
  }

 private:
  std::size_t before(std::size_t i) const { return (i + size() - 1) % size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % size(); }

  bool is_ear(std::size_t i) const {
    const Corner2 &a = left_[before(i)], &b = left_[i], &c = left_[after(i)];
    if (CGAL::orientation(a.at, b.at, c.at) != CGAL::LEFT_TURN) return false;
    for (const Corner2& other : left_)
      if (covers(a, b, c, other.at)) return false;
    return true;
  }

  std::vector<Corner2> left_;
  std::vector<bool> ear_;
};

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
  Ears ears(std::move(left));
  while (ears.size() >= 3) triangles.push_back(ears.cut());
}

}  // namespace suture
