// Small bodies, hostile changes to them, and a flow, for the tests of mesh improvement.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include "kernel/random.h"
#include "kernel/triangles.h"

namespace suture::bodies {

class Dice : public Random {
 public:
  using Random::Random;
  Point in_cube(double half) {
    const double x = uniform(-half, half), y = uniform(-half, half);
    return {x, y, uniform(-half, half)};
  }
};

/// A tetrahedron's, octahedron's or box's faces, each edge halved `times` times.
inline Triangles halved(Triangles s, int times) {
  for (; times > 0; --times) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] =
          middle.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(s.positions.size()));
      if (fresh) s.positions.push_back((s.positions[a] + s.positions[b]) / 2);
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : s.triangles) {
      const std::uint32_t ab = between(t[0], t[1]), bc = between(t[1], t[2]),
                          ca = between(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    s.triangles = std::move(finer);
  }
  return s;
}

/// 20·4^times triangles.
inline Triangles ball(int times, double radius = 1, const Point& centre = Point::Zero()) {
  const double g = (1 + std::sqrt(5.)) / 2;
  Triangles s =
      halved({{{-1, g, 0},
               {1, g, 0},
               {-1, -g, 0},
               {1, -g, 0},
               {0, -1, g},
               {0, 1, g},
               {0, -1, -g},
               {0, 1, -g},
               {g, 0, -1},
               {g, 0, 1},
               {-g, 0, -1},
               {-g, 0, 1}},
              {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}},
             times);
  for (Point& p : s.positions) p = centre + radius * p.normalized();
  return s;
}

/// The cube from 0 to 1, 12·4^times triangles.
inline Triangles cube(int times) {
  return halved(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
       {{0, 2, 3},
        {0, 3, 1},
        {4, 5, 7},
        {4, 7, 6},
        {0, 1, 5},
        {0, 5, 4},
        {2, 6, 7},
        {2, 7, 3},
        {0, 4, 6},
        {0, 6, 2},
        {1, 3, 7},
        {1, 7, 5}}},
      times);
}

/// A prism over a regular polygon, with flat fans for its caps: sharp rims, needles in the caps.
inline Triangles drum(int sides, int layers, double radius = 1, double height = 1) {
  Triangles s;
  const auto n = static_cast<std::uint32_t>(sides), m = static_cast<std::uint32_t>(layers);
  for (std::uint32_t j = 0; j <= m; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      s.positions.push_back({radius * std::cos(a), radius * std::sin(a), height * j / m});
    }
  for (std::uint32_t j = 0; j < m; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * n + i, b = j * n + (i + 1) % n;
      s.triangles.push_back({a, b, b + n});
      s.triangles.push_back({a, b + n, a + n});
    }
  const auto bottom = static_cast<std::uint32_t>(s.positions.size());
  s.positions.push_back({0, 0, 0});
  s.positions.push_back({0, 0, height});
  for (std::uint32_t i = 0; i < n; ++i) {
    s.triangles.push_back({bottom, (i + 1) % n, i});
    s.triangles.push_back({bottom + 1, m * n + i, m * n + (i + 1) % n});
  }
  return s;
}

/// Moves some vertices almost or exactly onto a neighbour, or onto the middle of a neighbouring
/// edge: needles, caps, triangles without area, coincident vertices.
inline Triangles tormented(Triangles s, Dice& dice, double share) {
  for (const Triangle& t : s.triangles) {
    if (dice.uniform(0, 1) > share) continue;
    const Point a = s.positions[t[0]], b = s.positions[t[1]];
    constexpr double kPull[5] = {1, 1 - 1e-12, 1 - 1e-6, 0.999, 0.9};
    const Point onto = dice.below(2) ? a : Point((a + b) / 2);
    Point& p = s.positions[t[2]];
    p += kPull[dice.below(5)] * (onto - p);
  }
  return s;
}

/// Arnold, Beltrami and Childress' flow, which has no divergence, with a turned copy of itself at
/// half the scale added; swings to and fro with period 1.
inline Point swinging_flow(const Point& p, double t) {
  const auto abc = [](const Point& x) {
    return Point(std::sin(x[2]) + std::cos(x[1]), std::sin(x[0]) + std::cos(x[2]),
                 std::sin(x[1]) + std::cos(x[0]));
  };
  const Point turned(2 * p[1] + 1, 2 * p[2] + 2, 2 * p[0] + 3);
  const Point u = abc(turned);
  return std::cos(2 * std::numbers::pi * t) * (abc(p) + Point(u[2], u[0], u[1]));
}

}  // namespace suture::bodies
