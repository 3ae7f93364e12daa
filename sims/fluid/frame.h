// A frame of the fluid: steps as short as it needs, topology at its end, earlier where it must.
#pragma once

#include <functional>

#include "sims/fluid/fluid.h"

namespace suture::sims {

/// All steps of a frame, for reports: what they had at worst.
struct FluidFrame {
  int steps = 0;
  /// dt and tension_share are the least, cfl, drops and residual the most, cells and liquid the
  /// last step's, unconverged the sum.
  FluidStep worst;
};

/// Steps to `end`, at most most_steps of them; `moved` hears of each one's length. Topology comes
/// between them where fluid.wants_topology() and `may_settle`, if the tracker keeps its triangles
/// till then, never after the last.
/// \pre end > fluid.time() \throw InvalidInput as Fluid::step
FluidFrame run_frame(Fluid& fluid, SurfaceTracker& surface, double end, int most_steps,
                     bool may_settle, const std::function<void(double)>& moved = nullptr);

/// The surface's topology, with the fluid told.
void settle(Fluid& fluid, SurfaceTracker& surface);

}  // namespace suture::sims
