// A frame in steps whose length is chosen once, at its start: so were the published rows made.
#pragma once

#include "tests/sims/fluid/runs.h"

namespace suture {

/// Differs from Run::frame, which chooses anew after each step, as the program does.
inline void frame_of_equal_steps(Run& run, double dt) {
  SurfaceTracker& surface = *run.surface;
  const int steps = run.fluid.steps_in(dt);
  for (int i = 0; i < steps; ++i) run.fluid.step(surface, dt / steps);
  run.fluid.before_remodel(surface);
  if (!surface.surface().triangles.empty()) surface.remodel();
  if (!surface.surface().triangles.empty()) surface.improve();
  run.fluid.after_remodel(surface);
}

}  // namespace suture
