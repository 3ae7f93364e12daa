// A scene's frames as a fluid makes them: steps as short as it needs, topology at their ends [§7].
#include "sims/driver/fluid_steps.h"

#include <algorithm>

#include "kernel/errors.h"
#include "kernel/measure/nearest_triangle.h"

namespace suture::sims {
namespace {

/// Each place begins with the velocity of the body that is nearest.
Fluid::Initial initial_velocity(const Scene& scene) {
  const std::vector<Point>& v = scene.velocities;
  if (v.empty() || std::all_of(v.begin(), v.end(), [&](const Point& p) { return p == v.front(); }))
    return [all = v.empty() ? Point(Point::Zero()) : v.front()](const Point&) { return all; };
  auto nearest = std::make_shared<NearestTriangle>(scene.surface);
  return [nearest, &scene](const Point& p) {
    return scene.velocities[scene.surface.triangles[nearest->triangle(p)][0]];
  };
}

}  // namespace

FluidSteps::FluidSteps(const Scene& scene)
    : scene_(scene),
      tracker_(make_surface_tracker(scene)),
      fluid_(*scene.fluid, initial_velocity(scene)) {
  const TimeOptions& time = scene.time;
  if (time.improve_every != 0 && time.remodel_every != 0 &&
      time.improve_every != time.remodel_every)
    throw InvalidInput(scene.file.string() +
                       ": time.improve_every must be as remodel_every, or 0: a fluid's surface is "
                       "looked after at the end of the same frames");
}

void FluidSteps::step(std::int64_t index, StepWatcher& watcher) {
  tracker_->watch(&watcher);
  const int every = std::max(scene_.time.remodel_every, scene_.time.improve_every);
  frame_ = run_frame(fluid_, *tracker_, step_end(scene_.time, index), scene_.fluid->most_steps,
                     every > 0, [&](double dt) { watcher.moved(dt); });
  if (every > 0 && (index % every == 0 || index == scene_.time.steps())) settle(fluid_, *tracker_);
  tracker_->watch(nullptr);
}

}  // namespace suture::sims
