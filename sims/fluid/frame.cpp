// A frame of the fluid: steps as short as it needs, topology at its end, earlier where it must.
#include "sims/fluid/frame.h"

#include <algorithm>
#include <utility>

namespace suture::sims {
namespace {

void add(FluidFrame& frame, const FluidStep& step) {
  FluidStep& w = frame.worst;
  const FluidStep before = std::exchange(w, step);
  if (frame.steps++ == 0) return;
  w.dt = std::min(w.dt, before.dt);
  w.tension_share = std::min(w.tension_share, before.tension_share);
  w.cfl = std::max(w.cfl, before.cfl);
  w.drops = std::max(w.drops, before.drops);
  w.residual = std::max(w.residual, before.residual);
  w.unconverged += before.unconverged;
}

}  // namespace

FluidFrame run_frame(Fluid& fluid, SurfaceTracker& surface, double end, int most_steps,
                     bool may_settle, const std::function<void(double)>& moved) {
  FluidFrame frame;
  for (double left = end - fluid.time(); left > 0;) {
    const int steps = std::clamp(fluid.steps_in(left), 1, std::max(1, most_steps - frame.steps));
    const double dt = left / steps;
    fluid.step(surface, dt);
    if (moved) moved(dt);
    add(frame, fluid.last());
    left = steps == 1 ? 0 : end - fluid.time();
    if (may_settle && left > 0 && surface.keeps_triangles() && fluid.wants_topology())
      settle(fluid, surface);
  }
  return frame;
}

void settle(Fluid& fluid, SurfaceTracker& surface) {
  fluid.before_remodel(surface.surface());
  surface.settle();
  fluid.after_remodel(surface.surface());
}

}  // namespace suture::sims
