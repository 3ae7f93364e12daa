// Positions as exact rationals, and whether a double is the nearest to one.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernel/lattice.h"
#include "kernel/triangles.h"

namespace suture::brute {

/// As rounding sees it: the infinities stand where the next doubles would be.
inline mpq_class exact(double x) {
  if (std::isfinite(x)) return mpq_class(x);
  const mpq_class beyond(mpz_class(1) << 1024);
  return x > 0 ? beyond : mpq_class(-beyond);
}

inline bool is_even(double x) {
  if (!std::isfinite(x)) return true;
  int exponent = 0;
  std::frexp(x, &exponent);
  const int last = std::max(exponent - 53, -1074);
  return std::fmod(std::ldexp(x, -last), 2) == 0;
}

/// Whether `rounded` is the double nearest to `value`, and the even one of two.
inline bool is_nearest(double rounded, const mpq_class& value) {
  const mpq_class distance = abs(exact(rounded) - value);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (double end : {-infinity, infinity}) {
    const double neighbour = std::nextafter(rounded, end);
    if (neighbour == rounded) continue;
    const int order = cmp(distance, mpq_class(abs(exact(neighbour) - value)));
    if (order > 0 || (order == 0 && !is_even(rounded))) return false;
  }
  return !std::isnan(rounded) && !(rounded == 0 && std::signbit(rounded));
}

struct EdgeQuestion {
  Point p, q;
  int axis, want;
  double plane;
};

inline mpq_class exact_on_edge(const EdgeQuestion& e) {
  const mpq_class p(e.p[e.axis]), q(e.q[e.axis]), plane(e.plane);
  const mpq_class from(e.p[e.want]), to(e.q[e.want]);
  return (from * (q - plane) + to * (plane - p)) / (q - p);
}

inline mpq_class twice_area(const Point& a, const Point& b, const Point& c, int u, int v) {
  const mpq_class au(a[u]), av(a[v]), bu(b[u]), bv(b[v]), cu(c[u]), cv(c[v]);
  return (bu - au) * (cv - av) - (bv - av) * (cu - au);
}

/// Where the line along `axis` through t[3] meets the triangle of the other three, by barycentric
/// weights: a way that the code under test does not go. `area` is twice that of its projection.
inline mpq_class exact_on_triangle(const std::array<Point, 4>& t, int axis, const mpq_class& area) {
  const int u = next_axis(axis), v = prev_axis(axis);
  const mpq_class wa = twice_area(t[3], t[1], t[2], u, v), wb = twice_area(t[3], t[2], t[0], u, v);
  const mpq_class wc = area - wa - wb;
  return (wa * mpq_class(t[0][axis]) + wb * mpq_class(t[1][axis]) + wc * mpq_class(t[2][axis])) /
         area;
}

}  // namespace suture::brute
