// What a study measures errors against: the first surface, a finer run, or a mesh file.
#include "sims/trade/reference.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/mesh_io.h"
#include "sims/stepper.h"
#include "sims/trade/one_run.h"

namespace suture {
namespace {

namespace fs = std::filesystem;

double number_of(const Settings& settings, const std::string& key) {
  const Value& value = setting(settings, key).value;
  if (const auto* i = std::get_if<std::int64_t>(&value)) return static_cast<double>(*i);
  return std::get<double>(value);
}

Reference from_start(const fs::path& scene, const fs::path& mesh) {
  write_triangles(mesh, read_scene(scene).surface);
  return {mesh, "start", "the first surface, to which the motion is to bring everything back"};
}

Reference from_file(const fs::path& file, const fs::path& mesh) {
  const Triangles surface = read_triangles(file);
  require_closed_manifold(surface, file.string());
  write_triangles(mesh, surface);
  return {mesh, "file", "the mesh " + file.string()};
}

Reference from_finer_run(const fs::path& scene, const fs::path& mesh,
                         const std::vector<PlannedRun>& runs, const ReferenceOptions& options) {
  const Settings own = settings_of(read_scene(scene));
  const SceneChanges changes = finest_changes(own, runs, options.finest);
  const std::string words = words_of(own, changes);
  Row row;
  in_processes(
      {0}, options.limit,
      [&](std::size_t) {
        return packed(run_once({.scene = scene,
                                .changes = changes,
                                .reference = {},
                                .topology = {},
                                .surface = mesh}));
      },
      [&](std::size_t, const Ended& ended) {
        if (ended.finished)
          row = unpacked(ended.said);
        else
          row.failure = ended.words();
      });
  if (row.outcome != kDoneRun)
    throw InvalidInput(
        fmt::format("the reference run ({}) failed: {}; give --reference FILE, a "
                    "larger --finest or a larger --limit-seconds",
                    words, row.failure));
  return {mesh, "finest",
          fmt::format("a finer run: {}; {:.0f} triangles, {:.1f} CPU seconds in the tracker", words,
                      row.figures.triangles_end, row.figures.tracker_seconds)};
}

/// The reference that an earlier study left, or none.
std::optional<Reference> earlier(const fs::path& mesh, const fs::path& note) {
  if (!fs::exists(mesh) || !fs::exists(note)) return {};
  const std::string text = read_file(note);
  const std::size_t colon = text.find(": ");
  if (colon == std::string::npos) return {};
  return Reference{mesh, text.substr(0, colon),
                   text.substr(colon + 2, text.find('\n') - colon - 2)};
}

}  // namespace

bool comes_back(const fs::path& file) {
  try {
    Scene scene = read_scene(file);
    scene.time.remodel_every = scene.time.improve_every = 0;
    scene.time.step /= 4;  // so that RK4's error is 256 times below the scene's own
    Stepper stepper(scene, scene.tracker);
    StepWatcher nobody;
    for (std::int64_t i = 1; i <= scene.time.steps(); ++i) stepper.step(i, nobody);
    double most = 0;
    for (std::size_t v = 0; v < scene.surface.positions.size(); ++v)
      most = std::max(
          most, (stepper.tracker().surface().positions[v] - scene.surface.positions[v]).norm());
    return most <= 1e-3 * scene.tracker.cell_size;
  } catch (const std::exception&) {
    return false;  // it leads out of the finite numbers, or cannot go on without surgery
  }
}

SceneChanges finest_changes(const Settings& own, const std::vector<PlannedRun>& runs,
                            double factor) {
  SceneChanges changes;
  for (const char* name : {"tracker.cell_size", "quality.edge_length", "time.step"}) {
    double least = number_of(own, name);
    for (const PlannedRun& run : runs)
      least = std::min(least, number_of(changed(own, run.changes), name));
    changes[name] = rounded_for_people(factor * least);
  }
  const double times = number_of(own, "time.step") / std::get<double>(changes["time.step"]);
  for (const char* name : {"time.remodel_every", "time.improve_every"})
    changes[name] = static_cast<std::int64_t>(number_of(own, name) * times + 0.5);
  changes["tracker.arithmetic"] = std::string("filtered");
  return changes;
}

Reference make_reference(const fs::path& scene, const fs::path& folder,
                         const std::vector<PlannedRun>& runs, const ReferenceOptions& options) {
  const fs::path mesh = folder / "reference.ply", note = folder / "reference.txt";
  std::string kind = options.kind;
  const auto left = earlier(mesh, note);
  if (left && (kind.empty() || kind == left->kind)) return *left;
  if (kind.empty()) kind = comes_back(scene) ? "start" : "finest";
  const Reference made = kind == "start"    ? from_start(scene, mesh)
                         : kind == "finest" ? from_finer_run(scene, mesh, runs, options)
                                            : from_file(kind, mesh);
  write_file(note, made.kind + ": " + made.words + "\n");
  return made;
}

}  // namespace suture
