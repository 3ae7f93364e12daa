// The order of a scene's steps: move, remodel, improve; who wants to know is told of each.
#pragma once

#include <cstdint>

#include "sims/scene.h"

namespace suture {

/// Told of each part of a step as it ends, before the motion hears of the changed surface.
class StepWatcher {
 public:
  virtual ~StepWatcher() = default;
  virtual void moved(double /*dt*/) {}
  virtual void remodelled(const SurgeryReport& /*report*/) {}
  virtual void improved(const QualityReport& /*report*/) {}
};

/// Takes a scene's surface through its steps. Keeps a reference to the scene, whose motions move.
class Stepper {
 public:
  /// \throw InvalidInput as Tracker
  Stepper(Scene& scene, const TrackerOptions& options)
      : scene_(scene), tracker_(scene.surface, options) {}

  const Tracker& tracker() const { return tracker_; }
  /// Whether nothing is left to move: every part got thinner than a cell and was split away.
  bool vanished() const { return tracker_.surface().triangles.empty(); }

  /// Step `index`, counted from 1. \throw as Tracker::advect, displace, improve
  void step(std::int64_t index, StepWatcher& watcher);

 private:
  Motion& phase();
  void surface_changed(const std::vector<std::uint32_t>& vertex_map);

  Scene& scene_;
  Tracker tracker_;
};

}  // namespace suture
