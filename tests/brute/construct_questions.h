// What construct can be asked, drawn near degeneracy, and whether an answer is correctly rounded.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "kernel/lattice.h"
#include "predicates/construct.h"
#include "tests/brute/sign_questions.h"

namespace suture::brute {

/// The number as rounding sees it: the infinities stand where the next doubles would be.
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

/// Whether `rounded` is the double nearest to `value`, the even one of two, and not −0.
inline bool is_nearest(double rounded, const mpq_class& value) {
  if (std::isnan(rounded) || (rounded == 0 && std::signbit(rounded))) return false;
  const mpq_class distance = abs(exact(rounded) - value);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (double end : {-kInfinity, kInfinity}) {
    const double neighbour = std::nextafter(rounded, end);
    if (neighbour == rounded) continue;
    const int order = cmp(distance, mpq_class(abs(exact(neighbour) - value)));
    if (order > 0 || (order == 0 && !is_even(rounded))) return false;
  }
  return true;
}

struct EdgeQuestion {
  Point p, q;
  int axis, want;
  double plane;
};

struct TriangleQuestion {
  Points4 points;  ///< the corners, and the point that the line goes through
  int axis;
};

inline double ask(const EdgeQuestion& e) { return on_edge(e.p, e.q, e.axis, e.plane, e.want); }
inline double ask(const TriangleQuestion& t) {
  return on_triangle(t.points[0], t.points[1], t.points[2], t.axis, t.points[3]);
}

/// The same of plain doubles.
inline double ask_rounded(const EdgeQuestion& e) {
  return rounded_on_edge(e.p, e.q, e.axis, e.plane, e.want);
}
inline double ask_rounded(const TriangleQuestion& t) {
  return rounded_on_triangle(t.points[0], t.points[1], t.points[2], t.axis, t.points[3]);
}

inline bool crosses(const EdgeQuestion& e) { return e.p[e.axis] != e.q[e.axis]; }

inline mpq_class twice_area(const Point& a, const Point& b, const Point& c, int axis) {
  const int u = next_axis(axis), v = prev_axis(axis);
  const mpq_class au(a[u]), av(a[v]), bu(b[u]), bv(b[v]), cu(c[u]), cv(c[v]);
  return (bu - au) * (cv - av) - (bv - av) * (cu - au);
}

inline bool crosses(const TriangleQuestion& t) {
  return twice_area(t.points[0], t.points[1], t.points[2], t.axis) != 0;
}

inline mpq_class exact(const EdgeQuestion& e) {
  const mpq_class p(e.p[e.axis]), q(e.q[e.axis]), plane(e.plane);
  const mpq_class from(e.p[e.want]), to(e.q[e.want]);
  return (from * (q - plane) + to * (plane - p)) / (q - p);
}

/// Uses barycentric weights, a way that the code under test does not go.
inline mpq_class exact(const TriangleQuestion& question) {
  const auto& [a, b, c, through] = question.points;
  const int axis = question.axis;
  const mpq_class area = twice_area(a, b, c, axis);
  const mpq_class wa = twice_area(through, b, c, axis), wb = twice_area(through, c, a, axis);
  const mpq_class wc = area - wa - wb;
  return (wa * mpq_class(a[axis]) + wb * mpq_class(b[axis]) + wc * mpq_class(c[axis])) / area;
}

inline std::string show(const EdgeQuestion& e) {
  return "on edge " + show(e.p) + show(e.q) + "plane " + show(e.plane) + std::to_string(e.axis) +
         std::to_string(e.want);
}

inline std::string show(const TriangleQuestion& t) {
  return "on triangle and through " + show(t.points) + std::to_string(t.axis);
}

/// The question, if `answer` is not correctly rounded; else nothing. \pre it crosses
template <class Question>
std::string mistake(const Question& question, double answer) {
  if (is_nearest(answer, exact(question))) return "";
  return show(answer) + show(question);
}

inline EdgeQuestion edge_question(Family family, Draws& random) {
  const Points4 points = near_degenerate(family, random);
  const int axis = random.below(3), want = (axis + random.between(1, 2)) % 3;
  return {points[0], points[1], axis, want, points[2][axis]};
}

inline TriangleQuestion triangle_question(Family family, Draws& random) {
  const Points4 points = near_degenerate(family, random);
  return {points, random.below(3)};
}

/// An edge whose point lies halfway between two doubles, or off it by as little as 2^-1000 of them.
inline EdgeQuestion edge_near_halfway(Draws& random) {
  EdgeQuestion e{random.point(), random.point(), 0, 1, 0};
  e.q[1] = nudged(e.p[1], 2 * random.below(3) + 1);
  e.p[0] = -1;
  e.q[0] = 1;
  if (random.below(4)) e.plane = std::ldexp(random.below(2) ? 1 : -1, -random.between(40, 1000));
  return e;
}

/// The same for a triangle: its heights differ by one ulp, and it is met near its middle.
inline TriangleQuestion triangle_near_halfway(Draws& random) {
  const double low = random.real(), high = nudged(low, 1);
  const double off = random.below(4) ? std::ldexp(1, -random.between(40, 1000)) : 0;
  const double y = random.real();
  return {{Point(-1, -1, low), Point(1, -1, high), Point(0, 1, random.below(2) ? low : high),
           Point(off, random.below(2) ? -1 : y, 0)},
          2};
}

}  // namespace suture::brute
