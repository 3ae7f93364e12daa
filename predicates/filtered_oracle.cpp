// The default oracle: floating point where a proven error bound allows, exact signs elsewhere, and
// ties broken symbolically as Simulation of Simplicity has it [§5.3, in place of jitter].
//
// The bounds, with u = 2^-53 and rounding to nearest. A difference of doubles is (x−y)(1+δ), |δ| ≤
// u, and never underflows; a product is xy(1+δ)+η, |η| < 2^-1074. Each monomial of a 2×2
// determinant of differences passes four roundings (two differences, product, sum), of a 3×3 one
// eight (three differences, product, sum, product, two sums); the sum of absolute values passes as
// many. So the error is below (4u + O(u²)), or (8u + O(u²)), times that computed sum, and one more
// u covers O(u²) and the bound's own roundings. What η adds is below 2·2^-1074 in the plane; in
// space it is multiplied by the third factor, and is below (3 + 2(|z₁|+|z₂|+|z₃|))·2^-1074 and its
// roundings: kUnderflow is far above both. Overflow makes the bound infinite or NaN, which decides
// nothing.
#include <cmath>

#include "predicates/exact_signs.h"
#include "predicates/floating_point.h"
#include "predicates/oracle.h"

namespace suture {

namespace {

constexpr double kRoundoff = 0x1p-53;
constexpr double kPlaneBound = 5 * kRoundoff;
constexpr double kSpaceBound = 9 * kRoundoff;
constexpr double kUnderflow = 1e-290;

constexpr int kUnknown = 2;

int sign_of(double x) { return (x > 0) - (x < 0); }

/// Sign of `value`, known to within `error`. It has no branch on the sign, which no processor can
/// foretell.
int decide(double value, double error) {
  const int sign = (value > error) - (value < -error);
  return sign != 0 ? sign : kUnknown;
}

/// Sign of x₁y₂ − y₁x₂ of rounded differences, whose own signs are exact.
int filtered_determinant(double x1, double y1, double x2, double y2) {
  const double left = x1 * y2, right = y1 * x2;
  const int sign =
      decide(left - right, kPlaneBound * (std::abs(left) + std::abs(right)) + kUnderflow);
  if (sign != kUnknown) return sign;
  // A factor that is zero, or products of opposite signs: decided without rounding, and common
  // where a mesh is aligned with the lattice.
  const int left_sign = sign_of(x1) * sign_of(y2), right_sign = sign_of(y1) * sign_of(x2);
  return left_sign != right_sign || left_sign == 0 ? sign_of(left_sign - right_sign) : kUnknown;
}

/// The two rows of differences whose determinant is twice an area: (q−p) and (r−p).
int filtered_orientation(const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                         const Eigen::Vector2d& r) {
  return filtered_determinant(q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]);
}

bool flat_along(int axis, const Point& a, const Point& b, const Point& c, const Point& d) {
  return a[axis] == b[axis] && a[axis] == c[axis] && a[axis] == d[axis];
}

/// Sign of (b−a)×(c−a)·(d−a).
int filtered_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double bc = bx * cy, cb = by * cx, cd = cx * dy, dc = cy * dx, db = dx * by, bd = dy * bx;
  const double heights = std::abs(bz) + std::abs(cz) + std::abs(dz);
  const double value = dz * (bc - cb) + bz * (cd - dc) + cz * (db - bd);
  const double size = std::abs(dz) * (std::abs(bc) + std::abs(cb)) +
                      std::abs(bz) * (std::abs(cd) + std::abs(dc)) +
                      std::abs(cz) * (std::abs(db) + std::abs(bd));
  const int sign = decide(value, kSpaceBound * size + kUnderflow * (1 + heights));
  if (sign != kUnknown) return sign;
  for (int axis = 0; axis < 3; ++axis)
    if (flat_along(axis, a, b, c, d)) return 0;
  return kUnknown;
}

Eigen::Vector2d across(const Point& p, int axis) {
  return {p[axis == 2 ? 0 : axis + 1], p[axis == 0 ? 2 : axis - 1]};
}

/// The sign that a shift of the lattice gives a point on the line pq: that of Δu ε_v − Δv ε_u, of
/// which the lower axis has the larger ε.
int edge_tie(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const LatticePoint2& at) {
  const int by_u = (q[1] < p[1]) - (q[1] > p[1]);
  const int by_v = (q[0] > p[0]) - (q[0] < p[0]);
  if (at.u_axis < at.v_axis) return by_u != 0 ? by_u : by_v;
  return by_v != 0 ? by_v : by_u;
}

class FilteredOracle final : public Oracle {
 public:
  int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const override {
    ++asked().edge_side;
    const int u = at.u_axis, v = at.v_axis;
    const int sign = filtered_determinant(q[u] - p[u], q[v] - p[v], at.u - p[u], at.v - p[v]);
    return sign != 0 && sign != kUnknown ? sign : hard_edge_side(sign, p, q, at);
  }

  int triangle_side(const Point& a, const Point& b, const Point& c,
                    const Point& node) const override {
    ++asked().triangle_side;
    const int sign = exactly(filtered_orientation(a, b, c, node), a, b, c, node);
    return sign != 0 ? sign : triangle_tie(a, b, c);
  }

  int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const override {
    ++asked().orientation;
    return exactly(filtered_orientation(a, b, c, d), a, b, c, d);
  }

 private:
  /// It stands apart from edge_side, which is then short: 3.6 ns a call where it was 9.8.
  int hard_edge_side(int filtered, const Point& p, const Point& q, const LatticePoint2& at) const {
    const Eigen::Vector2d from(p[at.u_axis], p[at.v_axis]), to(q[at.u_axis], q[at.v_axis]);
    const int sign = exactly(filtered, from, to, Eigen::Vector2d(at.u, at.v));
    return sign != 0 ? sign : edge_tie(from, to, at);
  }

  template <class... Points>
  int exactly(int filtered, const Points&... points) const {
    if (filtered != kUnknown) return filtered;
    ++asked().filter_failures;
    return exact_orientation(points...);
  }

  /// The sign that a shift of the lattice gives a node on the plane of abc: that of the normal's
  /// first component that is not zero.
  int triangle_tie(const Point& a, const Point& b, const Point& c) const {
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector2d p = across(a, axis), q = across(b, axis), r = across(c, axis);
      if (const int sign = exactly(filtered_orientation(p, q, r), p, q, r); sign != 0) return sign;
    }
    return 0;
  }
};

}  // namespace

std::unique_ptr<Oracle> make_filtered_oracle() {
  require_ieee_arithmetic();
  return std::make_unique<FilteredOracle>();
}

}  // namespace suture
