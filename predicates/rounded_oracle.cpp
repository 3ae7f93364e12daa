// Plain doubles, believed as they come, as the paper's authors had them before they jittered
// [§5.3].
#include "predicates/oracle.h"

namespace suture {

namespace {

int sign_of(double x) { return (x > 0) - (x < 0); }

class RoundedOracle final : public Oracle {
 public:
  int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const override {
    ++asked().edge_side;
    const int u = at.u_axis, v = at.v_axis;
    return sign_of((q[u] - p[u]) * (at.v - p[v]) - (q[v] - p[v]) * (at.u - p[u]));
  }

  int triangle_side(const Point& a, const Point& b, const Point& c,
                    const Point& node) const override {
    ++asked().triangle_side;
    return side(a, b, c, node);
  }

  int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const override {
    ++asked().orientation;
    return side(a, b, c, d);
  }

 private:
  static int side(const Point& a, const Point& b, const Point& c, const Point& d) {
    return sign_of((b - a).cross(c - a).dot(d - a));
  }
};

}  // namespace

std::unique_ptr<Oracle> make_rounded_oracle() { return std::make_unique<RoundedOracle>(); }

}  // namespace suture
