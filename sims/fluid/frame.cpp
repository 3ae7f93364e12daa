// A frame of the fluid: steps as short as it needs, topology at its end, earlier where it must.
#include "sims/fluid/frame.h"

#include <algorithm>

namespace suture {

void run_frame(Fluid& fluid, SurfaceTracker& surface, double end, int most_steps, bool may_settle,
               const std::function<void(double)>& moved) {
  int done = 0;
  for (double left = end - fluid.time(); left > 0;) {
    const int steps = std::clamp(fluid.steps_in(left), 1, std::max(1, most_steps - done));
    const double dt = left / steps;
    fluid.step(surface, dt);
    if (moved) moved(dt);
    ++done;
    left = steps == 1 ? 0 : end - fluid.time();
    if (may_settle && left > 0 && surface.keeps_triangles() && fluid.wants_topology())
      settle(fluid, surface);
  }
}

void settle(Fluid& fluid, SurfaceTracker& surface) {
  fluid.before_remodel(surface.surface());
  surface.settle();
  fluid.after_remodel(surface.surface());
}

}  // namespace suture
