// The order of a scene's steps: move, remodel, improve; who wants to know is told of each.
#pragma once

#include <cstdint>

#include "sims/scene/scene.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

class Fluid;
struct FluidFrame;

/// When step `index`, counted from 1, ends.
double step_end(const TimeOptions& time, std::int64_t index);

/// The motion of the step that begins at `time`.
Motion& phase_at(Scene& scene, double time);

/// A scene's surface on its way, whatever keeps it.
class Steps {
 public:
  virtual ~Steps() = default;

  /// Step `index`, counted from 1. \throw InvalidInput as the method's own advect
  virtual void step(std::int64_t index, StepWatcher& watcher) = 0;
  virtual const Triangles& surface() const = 0;
  virtual double time() const = 0;
  virtual TrackerCost cost() const { return {}; }              ///< where the method counts it
  virtual const Fluid* fluid() const { return nullptr; }       ///< that moves it; null: none
  virtual const FluidFrame* frame() const { return nullptr; }  ///< the fluid's last
  /// Whether nothing is left to move: every part got thinner than a cell and went.
  bool vanished() const { return surface().triangles.empty(); }
};

/// Takes a scene's mesh through its steps. Keeps a reference to the scene, whose motions move.
class Stepper : public Steps {
 public:
  /// \throw InvalidInput as Tracker, and for a scene whose method is not "mesh"
  Stepper(Scene& scene, const TrackerOptions& options);

  const Tracker& tracker() const { return tracker_; }
  const Triangles& surface() const override { return tracker_.surface(); }
  double time() const override { return tracker_.time(); }

  /// \throw as Tracker::advect, displace, improve
  void step(std::int64_t index, StepWatcher& watcher) override;

 private:
  void surface_changed(const std::vector<std::uint32_t>& vertex_map);

  Scene& scene_;
  Tracker tracker_;
};

}  // namespace suture::sims
