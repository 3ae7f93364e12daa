// Volume, area, angles and components; lengths are scaled before they are squared, so that no
// surface is too large or too small for them.
#include "kernel/measure/measures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "kernel/corners.h"
#include "kernel/lattice.h"
#include "kernel/union_find.h"

namespace suture {

namespace {

constexpr double kDegrees = 57.295779513082320877;

using Exact = Eigen::Matrix<long double, 3, 1>;  // 11 more bits, and an exponent that never ends

Exact centre(const Triangles& surface) {
  const Box box = bounding_box(surface.positions);
  return (box.low.cast<long double>() + box.high.cast<long double>()) / 2;
}

// Calls f(a, b, triangle) for each edge once, lower vertex first.
template <class F>
void for_each_edge(const Triangles& surface, F f) {
  const Corners corners(surface);
  std::vector<std::uint32_t> seen(surface.positions.size(), kNone);
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const auto v = static_cast<std::uint32_t>(i);
    for (const Corner& c : corners.of(v))
      for (const std::uint32_t other : {c.next, c.prev})
        if (other > v && seen[other] != v) {
          seen[other] = v;
          f(v, other);
        }
  }
}

// The angle at a of the triangle (a, b, c), degrees, by the tangent of its half: accurate for the
// smallest and the largest angles alike.
double angle(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - a;
  return std::atan2(u.cross(v).norm(), u.dot(v)) * kDegrees;
}

}  // namespace

double volume(const Triangles& surface) {
  if (surface.positions.empty()) return 0;
  const Exact middle = centre(surface);
  long double six = 0;
  for (const Triangle& t : surface.triangles) {
    const Exact a = surface.positions[t[0]].cast<long double>();
    const Exact b = surface.positions[t[1]].cast<long double>();
    const Exact c = surface.positions[t[2]].cast<long double>();
    six += (a - middle).dot((b - a).cross(c - a));  // local first: bodies may be far apart
  }
  return static_cast<double>(six / 6);
}

double area(const Triangles& surface) {
  long double two = 0;
  for (const Triangle& t : surface.triangles) {
    const Exact a = surface.positions[t[0]].cast<long double>();
    const Exact u = surface.positions[t[1]].cast<long double>() - a;
    const Exact v = surface.positions[t[2]].cast<long double>() - a;
    two += u.cross(v).norm();
  }
  return static_cast<double>(two / 2);
}

std::int64_t euler_characteristic(const Triangles& surface) {
  std::vector<std::uint8_t> used(surface.positions.size(), 0);
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  std::int64_t edges = 0;
  for_each_edge(surface, [&](std::uint32_t, std::uint32_t) { ++edges; });
  return std::count(used.begin(), used.end(), std::uint8_t{1}) - edges +
         static_cast<std::int64_t>(surface.triangles.size());
}

Components components(const Triangles& surface) {
  UnionFind sets(surface.positions.size());
  for (const Triangle& t : surface.triangles)
    for (const int i : {1, 2}) sets.join(t[0], t[i]);
  Components result;
  std::vector<std::uint32_t> number(sets.size(), kNone);
  result.of_triangle.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    std::uint32_t& n = number[sets.root(t[0])];
    if (n == kNone) n = static_cast<std::uint32_t>(result.count++);
    result.of_triangle.push_back(n);
  }
  return result;
}

EdgeLengths edge_lengths(const Triangles& surface) {
  EdgeLengths result;
  long double sum = 0;
  std::size_t count = 0;
  for_each_edge(surface, [&](std::uint32_t a, std::uint32_t b) {
    const double length = (surface.positions[a] - surface.positions[b]).stableNorm();
    result.shortest = count == 0 ? length : std::min(result.shortest, length);
    result.longest = std::max(result.longest, length);
    sum += length;
    ++count;
  });
  if (count > 0) result.mean = static_cast<double>(sum / count);
  return result;
}

Angles angles(const Triangles& surface) {
  if (surface.triangles.empty()) return {};
  Angles result{180, 0};
  for (const Triangle& t : surface.triangles) {
    const Point &a = surface.positions[t[0]], &b = surface.positions[t[1]],
                &c = surface.positions[t[2]];
    const double longest =
        std::max({(b - a).lpNorm<Eigen::Infinity>(), (c - b).lpNorm<Eigen::Infinity>(),
                  (a - c).lpNorm<Eigen::Infinity>()});
    const Point u = (b - a) / longest, v = (c - a) / longest;
    if (!(longest > 0) || u.cross(v).isZero(0)) return {0, 180};
    for (const double x :
         {angle(Point::Zero(), u, v), angle(u, v, Point::Zero()), angle(v, Point::Zero(), u)}) {
      result.smallest = std::min(result.smallest, x);
      result.largest = std::max(result.largest, x);
    }
  }
  return result;
}

}  // namespace suture
