// A scene's steps by whatever method it names: moved, and settled at the end.
#pragma once

#include <memory>

#include "sims/driver/driver.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// For methods that do for themselves what the Stepper does for a mesh: watchers hear of moves
/// only.
class MethodStepper : public Steps {
 public:
  /// \throw InvalidInput as make_surface_tracker, and for a motion that is no velocity field
  explicit MethodStepper(Scene& scene);

  void step(std::int64_t index, StepWatcher& watcher) override;
  const Triangles& surface() const override { return tracker_->surface(); }
  double time() const override { return tracker_->time(); }
  TrackerCost cost() const override { return tracker_->cost(); }

 private:
  Scene& scene_;
  std::unique_ptr<SurfaceTracker> tracker_;
};

/// A Stepper if the scene's method is "mesh", with these options; else a MethodStepper.
std::unique_ptr<Steps> make_steps(Scene& scene, const TrackerOptions& options);

}  // namespace suture::sims
