// The meshes, pictures and report that a run leaves in a folder.
#include "sims/driver/run_record.h"

#include <fmt/format.h>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/measures.h"
#include "sims/output/colours.h"
#include "sims/output/render.h"
#include "sims/output/report_json.h"
#include "sims/support/reproducer.h"
#include "sims/support/version.h"

namespace suture::sims {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kReportEvery = 10;  // steps; a killed run may lack so many in its report

double fading_of(const Scene& scene) {
  return scene.output.patch_fading > 0 ? scene.output.patch_fading : scene.time.end / 10;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InvalidInput(folder.string() + ": the folder cannot be made (" + error.message() +
                       "); choose another");
}

}  // namespace

RunRecord::RunRecord(Scene& scene, fs::path folder, const SceneSteps& steps)
    : scene_(scene),
      folder_(std::move(folder)),
      steps_(steps),
      ages_(scene.surface.positions.size(), fading_of(scene)) {
  if (!scene.output.picture.fit && scene.output.fit == Fit::first)
    scene.output.picture.fit = bounding_box(scene.surface.positions);
  make_folder(folder_);
  report_ = {{"program", "suture"},
             {"version", kVersion},
             {"scene", scene.file.string()},
             {"title", scene.title},
             {"notes", scene.notes},
             {"tracker", to_json(scene.tracker)},
             {"method", method_name(scene.method.kind)},
             {"steps", json::array()},
             {"remodels", json::array()},
             {"improvements", json::array()}};
}

void RunRecord::moved(double dt) {
  if (steps_.fluid() != nullptr) frame_.add(steps_.fluid()->last());
  ages_.moved(dt);
}

void RunRecord::remodelled(const SurgeryReport& report) {
  ++summary_.remodels;
  std::string reproducer;  // a refused surgery leaves the surface that it was given
  if (report.outcome == Outcome::refused)
    reproducer = save_reproducer(folder_ / "reproducers", summary_.remodels, surface()).string();
  note("remodels", to_json(report, reproducer));
  if (report.outcome == Outcome::refused && summary_.refused++ == 0) {
    summary_.reproducer = reproducer;
    summary_.failure = report.failure;
  }
  if (report.outcome != Outcome::committed) return;
  ++summary_.committed;
  const std::size_t vanished = report.vanished.size();
  summary_.vanished += vanished;
  const std::size_t left = report.components_before - vanished;
  if (report.components_after < left)
    summary_.merges += left - report.components_after;
  else
    summary_.splits += report.components_after - left;
  ages_.remodelled(report, surface());
}

void RunRecord::improved(const QualityReport& report) {
  if (!is_mesh() && steps_.fluid() == nullptr) return;  // the method's own cost counts these
  note("improvements", to_json(report));
  ages_.improved(report, surface());
}

/// Adds what a call of the tracker did to the report's list of this name.
void RunRecord::note(const char* list, json record) {
  record["step"] = steps_.index();
  record["time"] = steps_.time();
  report_[list].push_back(std::move(record));
}

std::size_t RunRecord::add_step() {
  const std::int64_t index = steps_.index();
  summary_.steps = index;
  json now = measured(surface());
  now["step"] = index;
  now["time"] = steps_.time();
  now["seconds"] = watch_.next();
  if (steps_.fluid() != nullptr) now["fluid"] = to_json(std::exchange(frame_, {}));
  if (is_mesh()) now["untouched_area"] = ages_.untouched_area(surface());
  const auto parts = now["components"].get<std::size_t>();
  const OutputOptions& output = scene_.output;
  const bool mesh = output.meshes.wants(index, scene_.time) && !steps_.vanished();
  const bool picture = output.pictures.wants(index, scene_.time);
  if (mesh) {
    const std::string name = fmt::format("{:05}.{}", index, output.mesh_format);
    write_triangles(folder_ / name, surface());
    now["mesh"] = name;
    ++summary_.meshes;
  }
  if (picture) {
    const std::string name = fmt::format("{:05}.png", index);
    render_png(surface(), colours(), output.picture, folder_ / name);
    now["picture"] = name;
    ++summary_.pictures;
  }
  now["output_seconds"] = watch_.next();
  report_["steps"].push_back(std::move(now));
  if (mesh || picture || index % kReportEvery == 0) write_report();
  return parts;
}

TriangleColours RunRecord::colours() const {
  if (scene_.output.colour == Colour::plain) return {};
  if (scene_.output.colour == Colour::components) return component_colours(surface());
  return !is_mesh() ? TriangleColours{} : patch_colours(surface(), ages_.freshness());
}

fs::path RunRecord::save_surface() const {
  const fs::path mesh = folder_ / "reproducer.ply";
  write_triangles(mesh, surface());
  return mesh;
}

void RunRecord::write_report(const std::string& failure) {
  const RunSummary& s = summary_;
  report_["summary"] = {
      {"finished", (s.steps == scene_.time.steps() || steps_.vanished()) && failure.empty()},
      {"vanished", steps_.vanished()},
      {"steps", s.steps},
      {"steps_asked", scene_.time.steps()},
      {"remodels", s.remodels},
      {"committed", s.committed},
      {"refused", s.refused},
      {"merges", s.merges},
      {"splits", s.splits},
      {"vanished_bodies", s.vanished},
      {"failure", failure}};
  if (steps_.fluid() != nullptr) report_["modules"] = to_json(steps_.fluid()->costs());
  if (!is_mesh() || steps_.fluid() != nullptr) report_["cost"] = to_json(steps_.cost());
  write_file(folder_ / "report.json", report_.dump(1) + "\n");
}

RunSummary RunRecord::finish() {
  if (steps_.fluid() != nullptr)
    for (const ModuleCost& module : steps_.fluid()->costs())
      summary_.unconverged += module.unconverged;
  summary_.audit = audit(surface());
  report_["audit"] = to_json(summary_.audit);
  write_report();
  return summary_;
}

}  // namespace suture::sims
