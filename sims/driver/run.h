// A scene from start to end, with all that it writes down on its way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "kernel/audit.h"
#include "sims/scene/scene.h"

namespace suture::sims {

/// The place of a run on its way.
struct Progress {
  std::int64_t step = 0, steps = 0;
  double time = 0;
  std::size_t triangles = 0, components = 0;
};

/// Hears of a run after each of its steps. Pass null where nobody listens.
class RunWatcher {
 public:
  virtual ~RunWatcher() = default;
  virtual void stepped(const Progress& progress) = 0;
};

/// The counts of a run, for its user's last line.
struct RunSummary {
  std::int64_t steps = 0;
  std::size_t remodels = 0, committed = 0, refused = 0, merges = 0, splits = 0;
  std::size_t meshes = 0, pictures = 0;
  std::string reproducer;  ///< of the first surgery that was refused
  std::string failure;     ///< why it was
  Audit audit;             ///< of the last surface
};

/// Runs the scene and writes meshes, pictures and report.json to `folder`, which is made. The
/// report is whole whenever the run stops; a refused surgery is counted and the run goes on.
/// \throw InvalidInput if the tracker refuses the scene (nothing is written then), the motion leads
/// out of the finite numbers, or a file cannot be written
/// \throw InternalFailure after saving the surface, named in the message, if a step breaks down
RunSummary run(Scene& scene, const std::filesystem::path& folder, RunWatcher* watcher = nullptr);

}  // namespace suture::sims
