// A scene from start to end: its steps, each written down, and what is kept where one breaks down.
#include "sims/driver/run.h"

#include <fmt/format.h>

#include "kernel/errors.h"
#include "sims/driver/run_record.h"
#include "sims/driver/scene_steps.h"

namespace suture::sims {
namespace {

void step_and_record(SceneSteps& steps, RunRecord& record, RunWatcher* watcher) {
  record.add_step();
  while (steps.more() && !steps.vanished()) {
    steps.step(record);
    const std::size_t parts = record.add_step();
    if (watcher != nullptr)
      watcher->stepped(
          {steps.index(), steps.count(), steps.time(), steps.surface().triangles.size(), parts});
  }
}

}  // namespace

RunSummary run(Scene& scene, const std::filesystem::path& folder, RunWatcher* watcher) {
  SceneSteps steps(scene);
  RunRecord record(scene, folder, steps);
  try {
    step_and_record(steps, record, watcher);
  } catch (const InvalidInput& error) {
    record.write_report(error.what());
    throw InvalidInput(
        fmt::format("{}: step {}: {}", scene.file.string(), steps.index(), error.what()));
  } catch (const std::exception& error) {
    const std::filesystem::path mesh = record.save_surface();
    record.write_report(error.what());
    throw InternalFailure(
        fmt::format("step {}", steps.index()),
        fmt::format("{}; the surface is saved as {}", error.what(), mesh.string()));
  }
  return record.finish();
}

}  // namespace suture::sims
