// The reference that a study measures errors against: the first surface, as it was or carried by
// the exact flow, a finer run, or a mesh file.
#include "sims/study/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "sims/driver/scene_steps.h"
#include "sims/study/table/trade_row.h"
#include "sims/study/trade_run.h"
#include "sims/support/fingerprint.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

double number_of(const Settings& settings, const std::string& key) {
  const Value& value = setting(settings, key).value;
  if (const auto* i = std::get_if<std::int64_t>(&value)) return static_cast<double>(*i);
  return std::get<double>(value);
}

Reference from_start(const fs::path& scene, const fs::path& mesh) {
  write_triangles(mesh, read_scene(scene).surface);
  return {mesh, "start",
          "the first surface, to which the motion is to bring everything back (only the end is "
          "measured: without improvement it comes back too, whatever it was like in between)"};
}

/// The surface carried through the scene's time by its motion alone, in steps so short that RK4's
/// error is 256 times below the scene's own.
Triangles carried_alone(Scene& scene, Triangles surface) {
  scene.surface = std::move(surface);
  scene.time.remodel_every = scene.time.improve_every = 0;
  scene.time.step /= 4;
  scene.method = {};  // vertices, whatever it is a reference for
  require_moved_mesh(scene);
  SceneSteps steps(scene);
  StepWatcher nobody;
  while (steps.more()) steps.step(nobody);
  return steps.surface();
}

Reference from_flow(const fs::path& file, const fs::path& mesh) {
  constexpr std::size_t most = 100000;  // half a minute, in the costliest of our fields
  Scene scene = read_scene(file);
  for (const Phase& phase : scene.phases)
    if (phase.motion->field() == nullptr)
      throw InvalidInput(file.string() + ": the motion " + phase.kind +
                         " depends on the surface, so it cannot be a reference by itself; give "
                         "--reference finest or a file");
  const Triangles end = carried_alone(scene, quartered(scene.surface, most));
  write_triangles(mesh, end);
  return {mesh, "flow",
          fmt::format("the first surface carried by the flow alone, subdivided to {} triangles",
                      end.triangles.size())};
}

Reference from_file(const fs::path& file, const fs::path& mesh) {
  const Triangles surface = read_triangles(file);
  require_closed_manifold(surface, file.string());
  write_triangles(mesh, surface);
  return {mesh, "file", "the mesh " + file.string()};
}

Reference from_finer_run(const StudyPlan& study, const fs::path& mesh, double factor) {
  const Settings own = settings_of(read_scene(study.scene));
  const SceneChanges changes = finest_changes(own, study.runs, factor);
  const std::string words = words_of(own, changes);
  const Row row = run_once(
      {.scene = study.scene, .changes = changes, .reference = {}, .topology = {}, .surface = mesh});
  if (failed(row))
    throw InvalidInput(
        fmt::format("the reference run ({}) failed: {}; give --reference FILE or a "
                    "larger --finest",
                    words, row.text("failure")));
  return {mesh, "finest",
          fmt::format("a finer run: {}; {:.0f} triangles, {:.1f} CPU seconds in the tracker", words,
                      row.number("triangles_end"), tracker_seconds(row))};
}

/// The line of reference.txt that says of which scene the reference is.
std::string scene_line(const fs::path& scene) {
  return "scene " + fingerprint(read_file(scene) + fingerprint(read_scene(scene).surface)) + "\n";
}

/// The reference that an earlier study of this scene left, or none.
std::optional<Reference> earlier(const fs::path& scene, const fs::path& mesh,
                                 const fs::path& note) {
  if (!fs::exists(mesh) || !fs::exists(note)) return {};
  const std::string text = read_file(note);
  const std::size_t colon = text.find(": "), end = text.find('\n');
  if (colon == std::string::npos || end == std::string::npos || colon > end) return {};
  if (text.substr(end + 1) != scene_line(scene)) return {};
  return Reference{mesh, text.substr(0, colon), text.substr(colon + 2, end - colon - 2)};
}

}  // namespace

bool comes_back(const fs::path& file) {
  try {
    Scene scene = read_scene(file);
    const Triangles start = scene.surface, end = carried_alone(scene, start);
    double most = 0;
    for (std::size_t v = 0; v < start.positions.size(); ++v)
      most = std::max(most, (end.positions[v] - start.positions[v]).norm());
    return most <= 1e-3 * scene.tracker.cell_size;
  } catch (const std::exception&) {
    return false;  // it leads out of the finite numbers, or cannot go on without surgery
  }
}

Triangles quartered(Triangles surface, std::size_t most) {
  while (4 * surface.triangles.size() < most && !surface.triangles.empty()) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto next = static_cast<std::uint32_t>(surface.positions.size());
      const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), next);
      if (fresh) surface.positions.push_back(0.5 * (surface.positions[a] + surface.positions[b]));
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : surface.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    surface.triangles = std::move(finer);
  }
  return surface;
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

Reference make_reference(const StudyPlan& study, const ReferenceOptions& options) {
  const fs::path mesh = study.folder / "reference.ply", note = study.folder / "reference.txt";
  const auto left = earlier(study.scene, mesh, note);
  if (left && (options.kind.empty() || options.kind == left->kind)) return *left;
  const auto make = [&] {
    std::string kind = options.kind;
    if (kind.empty()) kind = comes_back(study.scene) ? "start" : "finest";
    const Reference made = kind == "start"    ? from_start(study.scene, mesh)
                           : kind == "flow"   ? from_flow(study.scene, mesh)
                           : kind == "finest" ? from_finer_run(study, mesh, options.finest)
                                              : from_file(kind, mesh);
    write_file(note, made.kind + ": " + made.words + "\n" + scene_line(study.scene));
  };
  // In a process of its own: what it takes of memory is not to count for the runs.
  const Ended ended = in_process(options.limit, [&]() -> std::string {
    try {
      make();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  });
  if (!ended.finished)
    throw InvalidInput("the reference could not be made: " + ended.words() +
                       "; give --reference FILE or a larger --limit-seconds");
  if (!ended.said.empty()) throw InvalidInput(ended.said);
  const auto made = earlier(study.scene, mesh, note);
  if (!made) throw InvalidInput(note.string() + ": it cannot be read back; remove the file");
  return *made;
}

}  // namespace suture::sims
