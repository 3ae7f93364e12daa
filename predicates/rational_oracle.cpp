// The slow twin of the filtered oracle: whole numbers of GMP, and shifts that are real numbers.
//
// The lattice stands at ε = (2^-6000, 2^-12000, 2^-18000), and its signs are those of symbols
// ε₀ ≫ ε₁ ≫ ε₂ > 0 for all finite doubles, because a double is a multiple of 2^-1074 below 2^1024
// and a difference of two is below 2^1025.
//  - edge_side is D + n·ε, D a multiple of 2^-2148 and n = (−Δv, Δu) two differences. If D is not 0
//    it exceeds n·ε, which is below 2·2^(1025-6000) = 2^-4974. If it is, the leading term that is
//    not 0 is at least 2^-1074 ε_i, and the next below 2^1025 ε_i 2^-6000 = 2^-4975 ε_i.
//  - triangle_side is D + N·ε, D a multiple of 2^-3222, |N_i| < 2·2^2050 and N_i a multiple of
//    2^-2148. If D is not 0 it exceeds N·ε < 2·2^(2051-6000) = 2^-3948. If it is, the leading term
//    is at least 2^-2148 ε_i, and the rest below 2·2^2051 ε_i 2^-6000 = 2^-3948 ε_i.
#include <array>

#include "predicates/dyadic.h"
#include "predicates/oracle.h"

namespace suture {

namespace {

constexpr std::array<int, 3> kShift = {-6000, -12000, -18000};
constexpr int kFineGrid = kShift[2];

using Exact3 = std::array<mpz_class, 3>;

int grid_of(const Point& a, const Point& b, const Point& c, const Point& d) {
  return grid_exponent({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2]});
}

/// plane + ε_axis − x on the fine grid. \pre both are multiples of 2^grid
mpz_class shifted_difference(double plane, double x, int axis, int grid) {
  mpz_class difference = on_grid(plane, grid) - on_grid(x, grid);
  difference <<= static_cast<unsigned>(grid - kFineGrid);
  difference += mpz_class(1) << static_cast<unsigned>(kShift[axis] - kFineGrid);
  return difference;
}

Exact3 difference(const Point& to, const Point& from, int grid) {
  Exact3 result;
  for (int i = 0; i < 3; ++i) result[i] = on_grid(to[i], grid) - on_grid(from[i], grid);
  return result;
}

Exact3 normal(const Point& a, const Point& b, const Point& c, int grid) {
  const Exact3 s = difference(b, a, grid), t = difference(c, a, grid);
  return {s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
}

int sign_of_dot(const Exact3& x, const Exact3& y) {
  return sgn(mpz_class(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]));
}

class RationalOracle final : public Oracle {
 public:
  int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const override {
    ++asked().edge_side;
    const int i = at.u_axis, j = at.v_axis;
    const int grid = grid_exponent({p[i], p[j], q[i], q[j], at.u, at.v});
    const mpz_class along_u = on_grid(q[i], grid) - on_grid(p[i], grid);
    const mpz_class along_v = on_grid(q[j], grid) - on_grid(p[j], grid);
    const mpz_class to_u = shifted_difference(at.u, p[i], i, grid);
    const mpz_class to_v = shifted_difference(at.v, p[j], j, grid);
    return sgn(mpz_class(along_u * to_v - along_v * to_u));
  }

  int triangle_side(const Point& a, const Point& b, const Point& c,
                    const Point& node) const override {
    ++asked().triangle_side;
    const int grid = grid_of(a, b, c, node);
    Exact3 to_node;
    for (int i = 0; i < 3; ++i) to_node[i] = shifted_difference(node[i], a[i], i, grid);
    return sign_of_dot(normal(a, b, c, grid), to_node);
  }

  int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const override {
    ++asked().orientation;
    const int grid = grid_of(a, b, c, d);
    return sign_of_dot(normal(a, b, c, grid), difference(d, a, grid));
  }
};

}  // namespace

std::unique_ptr<Oracle> make_rational_oracle() { return std::make_unique<RationalOracle>(); }

}  // namespace suture
