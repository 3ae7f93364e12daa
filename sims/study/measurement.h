// A scene is run by a method and measured, as `suture measure` does.
#pragma once

#include "sims/driver/run.h"
#include "sims/study/compare.h"

namespace suture::sims {

struct MeasurementOptions {
  std::filesystem::path scene;
  SceneChanges changes;
  std::vector<double> at;            ///< times; empty: the scene's own, or its end
  std::string reference;             ///< "exact", "polyhedron", "none", a mesh; empty: the scene's
  double tolerance = 0;              ///< of the reference, in the scene's unit; 0: the scene's
  std::filesystem::path references;  ///< folder where references are kept; empty: nowhere
  std::filesystem::path surfaces;    ///< folder for the measured surfaces; empty: none is kept
  std::string name;                  ///< of the surfaces' files, before the time
  CompareOptions compare;
  double limit_seconds = std::numeric_limits<double>::infinity();  ///< CPU
};

/// Runs the scene by its method in a process of its own and measures the surface at each time. A
/// run that stops, crashes or takes too long is a row that says so. `command` goes into the rows.
/// \throw InvalidInput for a bad scene, before anything is run
std::vector<Row> measure(const MeasurementOptions& options, const std::string& command,
                         RunWatcher* watcher = nullptr);

}  // namespace suture::sims
