// A scene's frames as a fluid makes them: steps as short as it needs, topology at their ends [§7].
#pragma once

#include "sims/driver/driver.h"
#include "sims/fluid/frame.h"

namespace suture::sims {

/// The scene's `time.step` is a frame. Keeps a reference to the scene.
class FluidSteps : public Steps {
 public:
  /// \pre scene.fluid
  /// \throw InvalidInput as Fluid, make_surface_tracker; and where the surface would be looked
  /// after every few frames but not at the same ones
  explicit FluidSteps(const Scene& scene);

  /// Topology comes at the end of the frames that `time` says, and earlier where the surface has
  /// moved far (FluidOptions::topology_cells), unless `time` says never. Trackers that make a new
  /// surface in every step have no need of it.
  void step(std::int64_t index, StepWatcher& watcher) override;
  const Triangles& surface() const override { return tracker_->surface(); }
  double time() const override { return fluid_.time(); }
  TrackerCost cost() const override { return tracker_->cost(); }
  const Fluid* fluid() const override { return &fluid_; }
  const FluidFrame* frame() const override { return &frame_; }

 private:
  const Scene& scene_;
  std::unique_ptr<SurfaceTracker> tracker_;
  Fluid fluid_;
  FluidFrame frame_;
};

}  // namespace suture::sims
