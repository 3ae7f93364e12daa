// The one loop that steps a surface: a simulator moves it, a tracker keeps it, watchers hear of it.
#pragma once

#include <cstdint>
#include <limits>

#include "sims/tracking/simulator.h"

namespace suture::sims {

/// Hears of each part of a frame as it ends, before the simulator hears of the changed surface.
class StepWatcher {
 public:
  virtual ~StepWatcher() = default;
  virtual void moved(double /*dt*/) {}
  virtual void remodelled(const SurgeryReport& /*report*/) {}
  virtual void improved(const QualityReport& /*report*/) {}
};

inline constexpr int kLastFrame = std::numeric_limits<int>::max();  ///< at the end of no other

/// After how many frames the surface is looked after; 0: never. What is done at all is done after
/// the last frame too.
struct Schedule {
  int remodel_every = 1;
  int improve_every = 1;
  int end_every = kLastFrame;  ///< SurfaceTracker::end_of_frame, and topology within frames
};

enum class FrameIs { one_of_many, last };

/// Takes a surface from frame to frame. A frame is as many steps as the simulator asks for, one
/// where it does not, and then the remodel, the improvement and the end of a frame that are due.
class Driver {
 public:
  /// Keeps references to both. \throw InvalidInput if a number of frames is negative, or the
  /// schedule has remodels or improvements for a tracker that is no mesh
  Driver(SurfaceTracker& tracker, Simulator& simulator, const Schedule& schedule);

  /// Steps to the time `end`. A mesh is also looked after between two steps where the simulator
  /// wants topology, if the schedule ends frames at all. \pre end > the tracker's time()
  /// \throw as the tracker and the simulator do
  void frame(double end, StepWatcher& watcher, FrameIs which = FrameIs::one_of_many);

 private:
  struct Due {
    bool remodel, improve, end;
    bool any() const { return remodel || improve || end; }
  };

  Due due(FrameIs which) const;
  void move_to(double end, StepWatcher& watcher);
  void look_after(const Due& due, StepWatcher& watcher);
  bool vanished() const { return tracker_.surface().triangles.empty(); }

  SurfaceTracker& tracker_;
  Simulator& simulator_;
  Schedule schedule_;
  std::int64_t frames_ = 0;
};

}  // namespace suture::sims
