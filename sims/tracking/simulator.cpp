// The number of steps that a time is cut into.
#include "sims/tracking/simulator.h"

#include <algorithm>
#include <cmath>

namespace suture::sims {

int Simulator::steps_in(double left) const {
  // A quotient that rounding left just above a whole number is that number.
  constexpr double kRounding = 1e-9;
  const double longest = longest_step();
  const double steps = longest > 0 ? std::ceil(left / longest * (1 - kRounding)) : most_steps();
  return static_cast<int>(std::clamp<double>(steps, 1, most_steps()));
}

}  // namespace suture::sims
