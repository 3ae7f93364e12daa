// Positions of inserted vertices: balls first, whole numbers of GMP where these leave the rounding
// open [§6.1].
//
// A zero is returned as +0 whatever its sign would be, so that both ways give the same bits.
#include "predicates/construct.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernel/errors.h"
#include "kernel/lattice.h"
#include "predicates/ball.h"
#include "predicates/dyadic.h"

namespace suture {

namespace {

/// The way from a down to the plane of abc, as a fraction: N·(through−a) / N_axis over the two
/// other axes, s = b−a and t = c−a, for balls and whole numbers alike; the axes are in cyclic order
/// from the one wanted.
template <class Number>
struct PlaneOverLine {
  Number numerator, denominator;
};

template <class Number>
PlaneOverLine<Number> plane_over_line(const std::array<Number, 3>& s,
                                      const std::array<Number, 3>& t, const Number& to_u,
                                      const Number& to_v) {
  const Number normal_u = s[2] * t[0] - s[0] * t[2];
  const Number normal_v = s[0] * t[1] - s[1] * t[0];
  return {normal_u * to_u + normal_v * to_v, s[1] * t[2] - s[2] * t[1]};
}

/// The double nearest to numerator / denominator · 2^exponent, ties to even.
/// \throw InternalFailure if the denominator is zero: an oracle said that these two cross
double nearest(mpz_class numerator, mpz_class denominator, int exponent) {
  if (denominator == 0)
    throw InternalFailure("construct", "asked where two parallel elements cross");
  constexpr int kDigits = std::numeric_limits<double>::digits;
  constexpr int kFinest = std::numeric_limits<double>::min_exponent - kDigits;
  const bool negative = sgn(numerator) * sgn(denominator) < 0;
  numerator = abs(numerator);
  denominator = abs(denominator);
  const int magnitude = static_cast<int>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) -
                        static_cast<int>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  // The quotient is between 2^(magnitude-1) and 2^(magnitude+1): it may have one digit too many.
  for (int last = std::max(magnitude + exponent - kDigits, kFinest);; ++last) {
    const int shift = exponent - last;
    mpz_class above = numerator, below = denominator, quotient, rest;
    if (shift >= 0)
      above <<= static_cast<unsigned>(shift);
    else
      below <<= static_cast<unsigned>(-shift);
    mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), above.get_mpz_t(), below.get_mpz_t());
    if (mpz_sizeinbase(quotient.get_mpz_t(), 2) > kDigits) continue;
    const int half = cmp(mpz_class(2 * rest), below);
    if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()))) ++quotient;
    const double result = std::ldexp(quotient.get_d(), last);
    return negative ? -result : result;
  }
}

double exact_on_edge(double p, double q, double p_across, double q_across, double plane) {
  const int grid = grid_exponent({p, q, p_across, q_across, plane});
  const mpz_class from = on_grid(p, grid), across = on_grid(p_across, grid);
  const mpz_class extent = on_grid(q_across, grid) - across;
  const mpz_class reach = on_grid(plane, grid) - across;
  return nearest(from * extent + (on_grid(q, grid) - from) * reach, extent, grid);
}

double exact_on_triangle(const Point& a, const Point& b, const Point& c, double u, double v) {
  const int grid = grid_exponent({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], u, v});
  std::array<mpz_class, 3> from, s, t;
  for (int i = 0; i < 3; ++i) {
    from[i] = on_grid(a[i], grid);
    s[i] = on_grid(b[i], grid) - from[i];
    t[i] = on_grid(c[i], grid) - from[i];
  }
  const auto drop =
      plane_over_line<mpz_class>(s, t, on_grid(u, grid) - from[1], on_grid(v, grid) - from[2]);
  return nearest(from[0] * drop.denominator - drop.numerator, drop.denominator, grid);
}

Point cyclic_from(int axis, const Point& p) {
  return {p[axis], p[next_axis(axis)], p[prev_axis(axis)]};
}

}  // namespace

double on_edge(const Point& p, const Point& q, int axis, double plane, int want) {
  if (want == axis) return plane + 0.0;
  if (p[want] == q[want]) return p[want] + 0.0;
  const Ball part = exact_sum(plane, -p[axis]) / exact_sum(q[axis], -p[axis]);
  const Ball sum = Ball{p[want], 0, 0} + exact_sum(q[want], -p[want]) * part;
  if (const auto rounded = settled(sum)) return *rounded + 0.0;
  return exact_on_edge(p[want], q[want], p[axis], q[axis], plane) + 0.0;
}

double on_triangle(const Point& a, const Point& b, const Point& c, int axis, const Point& through) {
  if (a[axis] == b[axis] && a[axis] == c[axis]) return a[axis] + 0.0;
  const Point from = cyclic_from(axis, a), to_b = cyclic_from(axis, b), to_c = cyclic_from(axis, c);
  std::array<Ball, 3> s, t;
  for (int i = 0; i < 3; ++i) {
    s[i] = exact_sum(to_b[i], -from[i]);
    t[i] = exact_sum(to_c[i], -from[i]);
  }
  const double u = through[next_axis(axis)], v = through[prev_axis(axis)];
  const auto drop = plane_over_line<Ball>(s, t, exact_sum(u, -from[1]), exact_sum(v, -from[2]));
  const Ball height = Ball{from[0], 0, 0} - drop.numerator / drop.denominator;
  if (const auto rounded = settled(height)) return *rounded + 0.0;
  return exact_on_triangle(from, to_b, to_c, u, v) + 0.0;
}

double rounded_on_edge(const Point& p, const Point& q, int axis, double plane, int want) {
  if (want == axis) return plane;
  return p[want] + (q[want] - p[want]) * ((plane - p[axis]) / (q[axis] - p[axis]));
}

double rounded_on_triangle(const Point& a, const Point& b, const Point& c, int axis,
                           const Point& through) {
  const Point normal = (b - a).cross(c - a);
  const int u = next_axis(axis), v = prev_axis(axis);
  return a[axis] -
         (normal[u] * (through[u] - a[u]) + normal[v] * (through[v] - a[v])) / normal[axis];
}

double clamp_to_cell(double x, double low, double high) {
  if (x <= low) return std::nextafter(low, high);
  return x < high ? x : high;
}

}  // namespace suture
