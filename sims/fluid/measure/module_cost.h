// What each module of the fluid takes, so that reports can tell a scene what it pays for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sims/fluid/linear/linear_system.h"
#include "sims/support/clock.h"

namespace suture::sims {

struct ModuleCost {
  std::string name;
  double seconds = 0;  ///< CPU of this process
  /// The bytes of its arrays, the most in any step. What lives only while a step works on it is
  /// left out: matrices, search trees, lists of faces.
  std::size_t bytes = 0;
  std::int64_t calls = 0;
  std::int64_t iterations = 0;  ///< of linear solvers, where it has one
  double residual = 0;          ///< of these, the worst, as the solver's tolerance
  std::size_t unconverged = 0;  ///< solves that did not converge, whose last iterate was used
};

/// Costs by module, in the order in which they first acted.
class ModuleCosts {
 public:
  /// Runs act(), and counts it as the module's.
  template <class Act>
  void timed(const std::string& name, Act act) {
    const Lap lap;
    act();
    ModuleCost& cost = of(name);
    cost.seconds += lap.seconds();
    ++cost.calls;
  }
  void holds(const std::string& name, std::size_t bytes) {
    of(name).bytes = std::max(of(name).bytes, bytes);
  }
  void solved(const std::string& name, const SolveReport& report) {
    ModuleCost& cost = of(name);
    cost.iterations += report.iterations;
    cost.residual = std::max(cost.residual, report.residual);
    checked(name, report);
  }
  /// Counts a solve that did not converge, and nothing else of it.
  void checked(const std::string& name, const SolveReport& report) {
    if (!report.converged()) ++of(name).unconverged;
  }
  const std::vector<ModuleCost>& all() const { return costs_; }
  std::size_t unconverged() const {  ///< of all modules
    std::size_t sum = 0;
    for (const ModuleCost& cost : costs_) sum += cost.unconverged;
    return sum;
  }

 private:
  ModuleCost& of(const std::string& name) {
    for (ModuleCost& cost : costs_)
      if (cost.name == name) return cost;
    costs_.emplace_back().name = name;
    return costs_.back();
  }
  std::vector<ModuleCost> costs_;
};

/// One module's part of the costs, which it refers to.
class ModuleAccount {
 public:
  ModuleAccount(ModuleCosts& costs, std::string name) : costs_(costs), name_(std::move(name)) {}

  template <class Act>
  void timed(Act act) const {
    costs_.timed(name_, act);
  }
  void holds(std::size_t bytes) const { costs_.holds(name_, bytes); }
  void solved(const SolveReport& report) const { costs_.solved(name_, report); }
  void checked(const SolveReport& report) const { costs_.checked(name_, report); }

 private:
  ModuleCosts& costs_;
  std::string name_;
};

}  // namespace suture::sims
