// The driver loop: a scene's surface moved, remodelled, improved, and written down.
#include "sims/driver/run.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/measures.h"
#include "sims/driver/scene_steps.h"
#include "sims/fluid/frame.h"
#include "sims/output/colours.h"
#include "sims/output/render.h"
#include "sims/output/report_json.h"
#include "sims/support/clock.h"
#include "sims/support/reproducer.h"
#include "sims/support/version.h"
#include "sims/tracking/vertex_values.h"

namespace suture::sims {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kReportEvery = 10;  // steps; what a killed run may lack of its report

class Run : public StepWatcher {
 public:
  Run(Scene& scene, const fs::path& folder)
      : scene_(scene),
        folder_(folder),
        steps_(scene),
        freshness_(scene.surface.positions.size(), 0.0),
        resampled_(freshness_) {
    fading_ = scene.output.patch_fading > 0 ? scene.output.patch_fading : scene.time.end / 10;
    if (!scene.output.picture.fit && scene.output.fit == Fit::first)
      scene.output.picture.fit = bounding_box(scene.surface.positions);
    make_folder();
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

  RunSummary all(RunWatcher* watcher) {
    const std::int64_t steps = scene_.time.steps();
    try {
      record(0);
      while (steps_.more() && !steps_.vanished()) {
        frame_ = {};
        steps_.step(*this);
        summary_.steps = steps_.index();
        const std::size_t parts = record(steps_.index());
        if (watcher != nullptr)
          watcher->stepped(
              {steps_.index(), steps, steps_.time(), surface().triangles.size(), parts});
      }
    } catch (const InvalidInput& error) {
      stop(error.what());
      throw InvalidInput(
          fmt::format("{}: step {}: {}", scene_.file.string(), steps_.index(), error.what()));
    } catch (const std::exception& error) {
      const fs::path mesh = folder_ / "reproducer.ply";
      write_triangles(mesh, surface());
      stop(error.what());
      throw InternalFailure(
          fmt::format("step {}", steps_.index()),
          fmt::format("{}; the surface is saved as {}", error.what(), mesh.string()));
    }
    summary_.audit = audit(surface());
    report_["audit"] = to_json(summary_.audit);
    stop("");
    return summary_;
  }

 private:
  void make_folder() const {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error)
      throw InvalidInput(folder_.string() + ": the folder cannot be made (" + error.message() +
                         "); choose another");
  }

  void moved(double dt) override {
    if (steps_.fluid() != nullptr) frame_.add(steps_.fluid()->last());
    for (double& f : freshness_) f = fading_ > 0 ? std::max(0.0, f - dt / fading_) : 0.0;
  }

  void remodelled(const SurgeryReport& r) override {
    ++summary_.remodels;
    std::string reproducer;  // a refused surgery leaves the surface that it was given
    if (r.outcome == Outcome::refused)
      reproducer = save_reproducer(folder_ / "reproducers", summary_.remodels, surface()).string();
    note("remodels", to_json(r, reproducer));
    if (r.outcome == Outcome::refused && summary_.refused++ == 0) {
      summary_.reproducer = reproducer;
      summary_.failure = r.failure;
    }
    if (r.outcome != Outcome::committed) return;
    ++summary_.committed;
    if (r.components_after < r.components_before)
      summary_.merges += r.components_before - r.components_after;
    else
      summary_.splits += r.components_after - r.components_before;
    carry(r.vertex_map);
    std::vector<char> old(freshness_.size(), 0);
    for (const std::uint32_t v : r.vertex_map)
      if (v != kNone) old[v] = 1;
    for (std::size_t v = 0; v < old.size(); ++v)
      if (old[v] == 0) freshness_[v] = resampled_[v] = 1;
  }

  void improved(const QualityReport& r) override {
    if (!is_mesh() && steps_.fluid() == nullptr) return;  // their costs count improvements
    note("improvements", to_json(r));
    carry(r.vertex_map);
  }

  void carry(const std::vector<std::uint32_t>& vertex_map) {
    freshness_ = carried(freshness_, 0.0, surface(), vertex_map);
    resampled_ = carried(resampled_, 0.0, surface(), vertex_map);
  }

  /// The share of the area whose triangles have no corner that surgery made.
  double untouched_area() const {
    double untouched = 0, all = 0;
    for (const auto& t : surface().triangles) {
      const Point& a = surface().positions[t[0]];
      const double area =
          (surface().positions[t[1]] - a).cross(surface().positions[t[2]] - a).norm();
      all += area;
      if (std::max({resampled_[t[0]], resampled_[t[1]], resampled_[t[2]]}) < 0.5) untouched += area;
    }
    return all > 0 ? untouched / all : 1;
  }

  /// Adds what a call of the tracker did to the report's list of this name.
  void note(const char* list, json record) {
    record["step"] = steps_.index();
    record["time"] = steps_.time();
    report_[list].push_back(std::move(record));
  }

  bool is_mesh() const { return scene_.method.kind == MethodKind::mesh; }
  const Triangles& surface() const { return steps_.surface(); }

  /// Writes what this step is to leave. \return the number of components
  std::size_t record(std::int64_t index) {
    json now = measured(surface());
    now["step"] = index;
    now["time"] = steps_.time();
    now["seconds"] = watch_.next();
    if (steps_.fluid() != nullptr) now["fluid"] = to_json(frame_);
    if (is_mesh()) now["untouched_area"] = untouched_area();
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
    if (mesh || picture || index % kReportEvery == 0) stop("");
    return parts;
  }

  TriangleColours colours() const {
    if (scene_.output.colour == Colour::plain) return {};
    if (scene_.output.colour == Colour::components) return component_colours(surface());
    return !is_mesh() ? TriangleColours{} : patch_colours(surface(), freshness_);
  }

  /// Brings the report up to date; `failure` says why the run ends here, or nothing.
  void stop(const std::string& failure) {
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
        {"failure", failure}};
    if (steps_.fluid() != nullptr) report_["modules"] = to_json(steps_.fluid()->costs());
    if (!is_mesh() || steps_.fluid() != nullptr) report_["cost"] = to_json(steps_.cost());
    write_file(folder_ / "report.json", report_.dump(1) + "\n");
  }

  Scene& scene_;
  fs::path folder_;
  SceneSteps steps_;
  FluidFrame frame_;               ///< the last, where a fluid moves the surface
  std::vector<double> freshness_;  ///< of each vertex: 1 as surgery made it, fading to 0
  std::vector<double> resampled_;  ///< of each vertex: 1 as surgery made it, and it stays so
  double fading_ = 0;
  Lap watch_{wall_seconds};
  json report_;
  RunSummary summary_;
};

}  // namespace

RunSummary run(Scene& scene, const std::filesystem::path& folder, RunWatcher* watcher) {
  return Run(scene, folder).all(watcher);
}

}  // namespace suture::sims
