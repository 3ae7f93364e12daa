// A frame of the fluid, for reports: all steps of it together.
#include "sims/fluid/frame.h"

#include <algorithm>
#include <utility>

namespace suture::sims {

void FluidFrame::add(const FluidStep& step) {
  const FluidStep before = std::exchange(worst, step);
  if (steps++ == 0) return;
  worst.dt = std::min(worst.dt, before.dt);
  worst.tension_share = std::min(worst.tension_share, before.tension_share);
  worst.cfl = std::max(worst.cfl, before.cfl);
  worst.drops = std::max(worst.drops, before.drops);
  worst.residual = std::max(worst.residual, before.residual);
  worst.unconverged += before.unconverged;
}

}  // namespace suture::sims
