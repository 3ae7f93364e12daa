// An oracle that answers at random with a given probability: surgery must refuse or stay correct.
#pragma once

#include "kernel/random.h"
#include "predicates/oracle.h"

namespace suture {

/// Its answers depend on how many it has given: no threads may share it, unlike any other oracle.
class LyingOracle : public Oracle {
 public:
  LyingOracle(double probability, std::uint64_t seed)
      : truth_(make_filtered_oracle()), probability_(probability), random_(seed) {}

  int edge_side(const Point& p, const Point& q, const LatticePoint2& at) const override {
    return lies() ? any() : truth_->edge_side(p, q, at);
  }
  int triangle_side(const Point& a, const Point& b, const Point& c,
                    const Point& node) const override {
    return lies() ? any() : truth_->triangle_side(a, b, c, node);
  }
  int orientation(const Point& a, const Point& b, const Point& c, const Point& d) const override {
    return lies() ? any() : truth_->orientation(a, b, c, d);
  }

 private:
  bool lies() const { return random_.uniform() < probability_; }
  int any() const { return static_cast<int>(random_.below(3)) - 1; }

  std::unique_ptr<Oracle> truth_;
  double probability_;
  mutable Random random_;
};

}  // namespace suture
