// A frame of the fluid, for reports: all steps of it together.
#pragma once

#include "sims/fluid/fluid.h"

namespace suture::sims {

/// The steps of a frame at their worst.
struct FluidFrame {
  int steps = 0;
  /// dt and tension_share are the least, cfl, drops and residual the most, cells and liquid the
  /// last step's, unconverged the sum.
  FluidStep worst;

  /// Adds the frame's next step.
  void add(const FluidStep& step);
};

}  // namespace suture::sims
