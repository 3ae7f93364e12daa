// Bodies at the ends of what a mesh can be, for the tests and for the table in papers/.
#pragma once

#include <cmath>
#include <numbers>

#include "kernel/isosurface/isosurface.h"
#include "kernel/random.h"
#include "tests/surgery/support.h"

namespace suture {

using namespace suture::surgery;

/// Every coordinate × 2^exponent, as ldexp rounds it.
inline Triangles times_power(Triangles surface, int exponent) {
  for (Point& p : surface.positions)
    for (double& x : p) x = std::ldexp(x, exponent);
  return surface;
}

inline Triangles two_balls(int frequency = 8) {
  return together(ball(1, {0.013, 0.007, 0.003}, frequency), ball(1, {1.2, 0.3, 0.1}, frequency));
}

/// A tetrahedron with its right angle at `at` and legs of length `size`.
inline Triangles corner_tetrahedron(const Point& at, double size) {
  return {{at, at + Point(size, 0, 0), at + Point(0, size, 0), at + Point(0, 0, size)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

/// Two apexes over a ring of `n`: two vertices of valence n.
inline Triangles double_cone(std::uint32_t n, double radius = 1, double height = 1) {
  Triangles s;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    s.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  s.positions.push_back({0, 0, height});
  s.positions.push_back({0, 0, -height});
  for (std::uint32_t i = 0; i < n; ++i) {
    s.triangles.push_back({i, (i + 1) % n, n});
    s.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  return s;
}

/// A sheet of triangles and the same sheet turned over, sewn along the rim: closed, flat, no
/// volume.
inline Triangles pillow(std::uint32_t n, double size) {
  Triangles s;
  const auto rim = [n](std::uint32_t i, std::uint32_t j) {
    return i == 0 || j == 0 || i == n || j == n;
  };
  std::vector<std::uint32_t> back;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      s.positions.push_back({size * i / n, size * j / n, 0.25});
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const std::uint32_t v = j * (n + 1) + i;
      back.push_back(rim(i, j) ? v : static_cast<std::uint32_t>(s.positions.size()));
      if (!rim(i, j)) s.positions.push_back(Point(s.positions[v]));
    }
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      // Cut so that no triangle has all its vertices on the rim.
      const bool other = (i + 1 == n && j == 0) || (i == 0 && j + 1 == n);
      for (const Triangle& t : other ? std::vector<Triangle>{{a, b, d}, {b, c, d}}
                                     : std::vector<Triangle>{{a, b, c}, {a, c, d}}) {
        s.triangles.push_back(t);
        s.triangles.push_back({back[t[0]], back[t[2]], back[t[1]]});
      }
    }
  return s;
}

/// Balls of radius `radius` on a grid one apart, count in all; they touch above radius 0.5.
inline Triangles ball_grid(int count, double radius, int frequency = 2) {
  const Triangles one = ball(radius, Point::Zero(), frequency);
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  std::vector<Triangles> all;
  for (int i = 0; i < count; ++i)
    all.push_back(
        translated(one, Point(i % side + 0.013, i / side % side + 0.007, i / side / side + 0.003)));
  return merged(all);
}

/// Balls inside balls, `count` deep, radii from 1 down; every second one turned, with cavities.
inline Triangles nested(int count, bool cavities, int frequency = 8) {
  std::vector<Triangles> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(ball(1 - 0.9 * i / count, Point(0.013, 0.007, 0.003), frequency));
    if (cavities && i % 2 == 1)
      for (Triangle& t : all.back().triangles) std::swap(t[1], t[2]);
  }
  return merged(all);
}

/// A gyroid of `cells` periods-per-two-cells in a box: every lattice cell of size 1 holds mesh.
inline Triangles gyroid(int cells, double edge) {
  const double size = cells, wave = std::numbers::pi;  // a period of two cells
  const auto field = [=](const Point& p) {
    const double g = std::sin(wave * p[0]) * std::cos(wave * p[1]) +
                     std::sin(wave * p[1]) * std::cos(wave * p[2]) +
                     std::sin(wave * p[2]) * std::cos(wave * p[0]);
    const double outside = std::max({-p.minCoeff(), p.maxCoeff() - size});
    return std::max(g, outside * 4);
  };
  return isosurface(field, {Point::Constant(-0.5), Point::Constant(size + 0.5)}, edge);
}

/// Every third vertex moved to within `gap` of a neighbour: slivers of aspect about 1 / gap.
inline Triangles with_slivers(Triangles surface, double gap) {
  std::vector<char> fixed(surface.positions.size(), 0);
  for (const Triangle& t : surface.triangles) {
    if (fixed[t[0]] || fixed[t[1]] || (t[0] + t[1]) % 3 != 0) continue;
    Point& p = surface.positions[t[0]];
    const Point& q = surface.positions[t[1]];
    p = q + gap * (p - q);
    fixed[t[0]] = fixed[t[1]] = 1;
  }
  return surface;
}

}  // namespace suture
