// One method on one scene, from start to end, with what it costs and its surface at given times.
#pragma once

#include "sims/driver/run.h"
#include "sims/scene/scene.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// The surface and all costs until a time; measuring itself is not among them.
struct Snapshot {
  double time = 0;
  Triangles surface;
  double steps = 0;
  double seconds = 0;         ///< CPU, of moving, looking after and contouring the surface
  double peak_megabytes = 0;  ///< of the process since the run began
  double triangles_mean = 0, triangles_max = 0;  ///< over the steps; where a surface is contoured
                                                 ///< only when asked for, over the snapshots
  TrackerCost cost;
};

struct MethodRun {
  std::vector<Snapshot> snapshots;
  std::string outcome;  ///< as in a study's rows: "done", "refused", "stopped"
  std::string failure;
};

/// Runs the scene by its method. Snapshots are taken at the first step that reaches each of
/// `times`, or where the scene's `until_components` ends it; if it stops before, there is one at
/// its last step. Of a mesh that vanished there is an empty one at each time that was left. Motions
/// that depend on the surface need a mesh. What the method or the scene throws is an outcome.
MethodRun run_method(Scene& scene, std::vector<double> times, RunWatcher* watcher = nullptr);

}  // namespace suture::sims
