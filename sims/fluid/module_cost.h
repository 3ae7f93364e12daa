// What each effect of the fluid takes, so that reports can tell a scene what it pays for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "sims/support/process_pool.h"

namespace suture::sims {

struct ModuleCost {
  std::string name;
  double seconds = 0;  ///< CPU of this process
  /// Of its arrays, the most in any step. What lives only while a step works on it is left out:
  /// matrices, search trees, lists of faces.
  std::size_t bytes = 0;
  std::int64_t calls = 0;
  std::int64_t iterations = 0;  ///< of linear solvers, where it has one
  double residual = 0;          ///< of these, the worst, as the solver's tolerance
};

/// Costs by module, in the order in which they first acted.
class ModuleCosts {
 public:
  /// Runs act(), and counts it as the module's.
  template <class Act>
  void timed(const std::string& name, Act act) {
    const double start = process_seconds();
    act();
    ModuleCost& cost = of(name);
    cost.seconds += process_seconds() - start;
    ++cost.calls;
  }
  void holds(const std::string& name, std::size_t bytes) {
    of(name).bytes = std::max(of(name).bytes, bytes);
  }
  void iterated(const std::string& name, int iterations, double residual) {
    ModuleCost& cost = of(name);
    cost.iterations += iterations;
    cost.residual = std::max(cost.residual, residual);
  }
  const std::vector<ModuleCost>& all() const { return costs_; }

 private:
  ModuleCost& of(const std::string& name) {
    for (ModuleCost& cost : costs_)
      if (cost.name == name) return cost;
    costs_.push_back({name, 0, 0, 0, 0, 0});
    return costs_.back();
  }
  std::vector<ModuleCost> costs_;
};

}  // namespace suture::sims
