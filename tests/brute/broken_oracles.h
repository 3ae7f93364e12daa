// Oracles that are wrong in one way each, to show that the tests would notice.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "predicates/oracle.h"

namespace suture::brute {

/// Right without ties. At a tie, as if axis i were shifted by sign·ε of axis rank[i]: the question
/// is put to a right oracle in a frame with its axes renamed or all turned round.
class WrongShift final : public Oracle {
 public:
  WrongShift(std::array<int, 3> rank, int sign) : rank_(rank), sign_(sign) {}

  int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const override {
    return inner_->edge_side(renamed(p), renamed(q),
                             {rank_[at.u_axis], rank_[at.v_axis], sign_ * at.u, sign_ * at.v});
  }
  int triangle_side(const Point& a, const Point& b, const Point& c,
                    const Point& node) const override {
    return handedness() * inner_->triangle_side(renamed(a), renamed(b), renamed(c), renamed(node));
  }
  int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const override {
    return inner_->orientation(a, b, c, d);
  }

 private:
  Point renamed(const Point& p) const {
    Point result;
    for (int i = 0; i < 3; ++i) result[rank_[i]] = sign_ * p[i];
    return result;
  }
  int handedness() const {
    const bool odd = (rank_[0] > rank_[1]) ^ (rank_[0] > rank_[2]) ^ (rank_[1] > rank_[2]);
    return odd ? -sign_ : sign_;
  }

  std::array<int, 3> rank_;
  int sign_;
  std::unique_ptr<Oracle> inner_ = make_filtered_oracle();
};

/// Breaks an edge's ties by the order in which the two axes are named, not by their numbers.
class NamedOrder final : public Oracle {
 public:
  int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const override {
    const Point from(p[at.u_axis], p[at.v_axis], 0), to(q[at.u_axis], q[at.v_axis], 0);
    return inner_->edge_side(from, to, {0, 1, at.u, at.v});
  }
  int triangle_side(const Point& a, const Point& b, const Point& c,
                    const Point& node) const override {
    return inner_->triangle_side(a, b, c, node);
  }
  int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const override {
    return inner_->orientation(a, b, c, d);
  }

 private:
  std::unique_ptr<Oracle> inner_ = make_filtered_oracle();
};

/// A floating-point filter believes its error to be relative · (sum of absolute products) +
/// absolute + by_height · (sum of the third factors).
struct Bound {
  double relative, absolute, by_height;
};

/// Trusts a bound that may be too small, and is right where that does not decide.
class WeakFilter final : public Oracle {
 public:
  explicit WeakFilter(Bound bound) : bound_(bound) {}

  int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const override {
    const double left = (q[at.u_axis] - p[at.u_axis]) * (at.v - p[at.v_axis]);
    const double right = (q[at.v_axis] - p[at.v_axis]) * (at.u - p[at.u_axis]);
    const double error = bound_.relative * (std::abs(left) + std::abs(right)) + bound_.absolute;
    if (std::abs(left - right) > error) return left > right ? 1 : -1;
    return inner_->edge_side(p, q, at);
  }
  int triangle_side(const Point& a, const Point& b, const Point& c,
                    const Point& node) const override {
    const int sign = filtered(a, b, c, node);
    return sign != 0 ? sign : inner_->triangle_side(a, b, c, node);
  }
  int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const override {
    const int sign = filtered(a, b, c, d);
    return sign != 0 ? sign : inner_->orientation(a, b, c, d);
  }

 private:
  int filtered(const Point& a, const Point& b, const Point& c, const Point& d) const {
    const Point s = b - a, t = c - a, r = d - a;
    double value = 0, size = 0, heights = 0;
    for (int i = 0; i < 3; ++i) {
      const Point& x = i == 0 ? r : i == 1 ? s : t;
      const Point& y = i == 0 ? s : i == 1 ? t : r;
      const Point& z = i == 0 ? t : i == 1 ? r : s;
      value += x[2] * (y[0] * z[1] - y[1] * z[0]);
      size += std::abs(x[2]) * (std::abs(y[0] * z[1]) + std::abs(y[1] * z[0]));
      heights += std::abs(x[2]);
    }
    const double error = bound_.relative * size + bound_.absolute + bound_.by_height * heights;
    return std::abs(value) > error ? (value > 0 ? 1 : -1) : 0;
  }

  Bound bound_;
  std::unique_ptr<Oracle> inner_ = make_filtered_oracle();
};

}  // namespace suture::brute
