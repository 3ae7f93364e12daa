// A scene run from start to end by whatever tracks its surface: the surface and all costs at times.
#pragma once

#include "sims/driver/run.h"
#include "sims/scene/scene.h"
#include "sims/support/clock.h"

namespace suture::sims {

/// The surface and all costs until a time; measuring itself is not among them.
struct Snapshot {
  double time = 0;
  Triangles surface;
  double steps = 0;
  double seconds = 0;         ///< CPU, of moving, looking after and contouring the surface
  double peak_megabytes = 0;  ///< of the process since the run began
  /// Over the steps; where a surface is contoured only when asked for, over the snapshots.
  double triangles_mean = 0, triangles_max = 0;
  double triangles = 0;  ///< when they were last counted
  Costs costs;           ///< by part of the work, and counts of what was done
};

struct SceneRun {
  std::vector<Snapshot> snapshots;
  std::string outcome;  ///< kDoneRun, kRefusedRun or kStoppedRun
  std::string failure;  ///< why it stopped or nothing was left
  std::string refusal;  ///< why the first surgery that was refused was
};

/// Runs the scene by its method. Snapshots are taken at the first step that reaches each of
/// `times`, or where the scene's `until_components` ends it; if it stops before, there is one at
/// its last step, without a surface. Of a surface that vanished there is an empty one at each time
/// that was left. What the method or the scene throws is an outcome.
SceneRun run_scene(Scene& scene, std::vector<double> times, RunWatcher* watcher = nullptr);

}  // namespace suture::sims
