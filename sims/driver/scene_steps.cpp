// A scene's steps by whatever method it names: moved, and settled at the end.
#include "sims/driver/scene_steps.h"

#include "kernel/errors.h"
#include "sims/driver/fluid_steps.h"

namespace suture::sims {

MethodStepper::MethodStepper(Scene& scene) : scene_(scene), tracker_(make_surface_tracker(scene)) {
  for (const Phase& phase : scene.phases)
    if (phase.motion->field() == nullptr)
      throw InvalidInput(scene.file.string() + ": the method \"" + method_name(scene.method.kind) +
                         "\" moves along velocity fields, and \"" + phase.kind +
                         "\" is none; choose the method \"mesh\"");
}

void MethodStepper::step(std::int64_t index, StepWatcher& watcher) {
  const double dt = step_end(scene_.time, index) - time();
  tracker_->advect(*phase_at(scene_, time()).field(), dt);
  watcher.moved(dt);
  if (index == scene_.time.steps()) tracker_->settle();
}

std::unique_ptr<Steps> make_steps(Scene& scene, const TrackerOptions& options) {
  if (scene.fluid) {
    scene.tracker = options;
    return std::make_unique<FluidSteps>(scene);
  }
  if (scene.method.kind == MethodKind::mesh) return std::make_unique<Stepper>(scene, options);
  return std::make_unique<MethodStepper>(scene);
}

}  // namespace suture::sims
