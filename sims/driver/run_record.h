// The meshes, pictures and report that a run leaves in a folder.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "sims/driver/patch_ages.h"
#include "sims/driver/run.h"
#include "sims/driver/scene_steps.h"
#include "sims/fluid/frame.h"
#include "sims/support/clock.h"

namespace suture::sims {

/// Watches the steps of a run and writes them down. Keeps references to the scene and the steps.
class RunRecord : public StepWatcher {
 public:
  /// Makes the folder, and fits the scene's camera to the first surface where it asks for that.
  /// \throw InvalidInput if the folder cannot be made
  RunRecord(Scene& scene, std::filesystem::path folder, const SceneSteps& steps);

  /// Writes down the surface at the start or after a step. \return its number of components
  /// \throw InvalidInput if a file cannot be written
  std::size_t add_step();

  /// Saves the surface as it is now. \return the file
  std::filesystem::path save_surface() const;

  /// Brings report.json up to date; `failure` says why the run ends here, or nothing.
  void write_report(const std::string& failure = "");

  /// Adds the audit of the last surface. \return what the run did
  RunSummary finish();

  void moved(double dt) override;
  void remodelled(const SurgeryReport& report) override;
  void improved(const QualityReport& report) override;

 private:
  void note(const char* list, nlohmann::json record);
  TriangleColours colours() const;
  bool is_mesh() const { return scene_.method.kind == MethodKind::mesh; }
  const Triangles& surface() const { return steps_.surface(); }

  Scene& scene_;
  std::filesystem::path folder_;
  const SceneSteps& steps_;
  PatchAges ages_;
  FluidFrame frame_;  ///< since the last step, where a fluid moves the surface
  Lap watch_{wall_seconds};
  nlohmann::json report_;
  RunSummary summary_;
};

}  // namespace suture::sims
