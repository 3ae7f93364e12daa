// A scene run by a method and measured: what `suture measure` does.
#include "sims/study/measurement.h"

#include <fmt/format.h>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/measures.h"
#include "sims/study/scene_run.h"
#include "sims/study/settings.h"
#include "sims/study/surface_measures.h"
#include "sims/study/table/table.h"
#include "sims/support/fingerprint.h"
#include "sims/support/process_pool.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

std::string changes_in_words(const SceneChanges& changes) {
  std::string words;
  for (const auto& [name, value] : changes)
    words += (words.empty() ? "" : " ") + name + "=" + text_of(value);
  return words;
}

/// The first columns say what was asked for.
Row setting_cells(const Scene& scene, const SceneChanges& changes, const std::string& command) {
  const TrackerOptions& t = scene.tracker;
  const double edge = t.quality.edge_length > 0 ? t.quality.edge_length : t.cell_size;
  const double domain = scene.measure.domain;
  return {{"scene", scene.file.stem().string()},
          {"method", method_name(scene.method.kind)},
          {"resolution", domain > 0 ? domain / t.cell_size : kUnknown},
          {"cell_size", t.cell_size},
          {"edge_length", edge},
          {"time_step", scene.time.step},
          {"topology_interval", std::to_string(scene.time.remodel_every)},
          {"improve_interval", std::to_string(scene.time.improve_every)},
          {"start_triangles", std::to_string(scene.surface.triangles.size())},
          {"changes", changes_in_words(changes)},
          {"command", command}};
}

std::string in_words(const Costs::List& parts) {
  std::string words;
  for (const auto& [name, value] : parts)
    words += fmt::format("{}{}={:.6g}", words.empty() ? "" : " ", name, value);
  return words;
}

Row cost_cells(const Snapshot& s) {
  const double work = 1e-6 * s.triangles_mean * s.steps;
  return {{"steps", s.steps},
          {"seconds", s.seconds},
          {"seconds_per_million_triangle_steps", work > 0 ? s.seconds / work : kUnknown},
          {"seconds_by_part", in_words(s.costs.seconds)},
          {"peak_megabytes", s.peak_megabytes},
          {"triangles", std::to_string(s.surface.triangles.size())},
          {"triangles_mean", s.triangles_mean},
          {"triangles_max", s.triangles_max},
          {"cells_resampled", s.costs.count_of("cells_resampled")},
          {"surgeries", s.costs.count_of("surgeries_committed")},
          {"refused", s.costs.count_of("surgeries_refused")},
          {"counts", in_words(s.costs.counts)}};
}

Row shape_cells(const Triangles& surface, const Scene& scene) {
  const bool as_at_first = scene.measure.reference != "none";
  const auto expected = [&](const std::optional<int>& given, std::int64_t own) {
    return given ? std::to_string(*given) : as_at_first ? std::to_string(own) : "";
  };
  const SurfaceMeasures m = measure_surface(surface);
  const double v = volume(surface);
  return {
      {"components", m.components},
      {"components_expected", expected(scene.measure.components,
                                       static_cast<std::int64_t>(components(scene.surface).count))},
      {"euler", m.euler},
      {"euler_expected", expected(scene.measure.euler, euler_characteristic(scene.surface))},
      {"closed_manifold", audit(surface).closed_manifold() ? "yes" : "no"},
      {"self_intersecting_pairs", m.intersecting_pairs},
      {"triangles_without_area", m.without_area},
      {"least_angle", m.least_angle},
      {"volume", v},
      {"volume_drift", v / volume(scene.surface) - 1}};
}

/// A run and its measuring, in the process that was made for it.
class Work {
 public:
  Work(const MeasurementOptions& options, const std::string& command)
      : options_(options), scene_(read_scene(options.scene, options.changes)) {
    settings_.set("run", options.name);
    settings_.append(setting_cells(scene_, options.changes, command));

    if (!options.reference.empty()) scene_.measure.reference = options.reference;
    if (options.tolerance > 0) scene_.measure.tolerance = options.tolerance;
    require_times();
    require_reference();
    if (fs::path(options.name).filename() != options.name)
      throw InvalidInput("the name \"" + options.name +
                         "\" of the surfaces' files leads to another "
                         "folder; give it without one");
  }

  std::vector<double> times() const {
    if (!options_.at.empty()) return options_.at;
    return scene_.measure.at.empty() ? std::vector<double>{scene_.time.end} : scene_.measure.at;
  }

  const Row& settings() const { return settings_; }

  std::vector<Row> all(RunWatcher* watcher) {
    const Triangles start = scene_.surface;
    const SceneRun run = run_scene(scene_, times(), watcher);
    std::vector<Row> rows;
    for (const Snapshot& s : run.snapshots) {
      Row row = settings_;
      const bool last = &s == &run.snapshots.back();
      row.append({{"time", s.time},
                  {"outcome", last ? run.outcome : "done"},
                  {"failure", last ? run.failure : ""}});
      row.append(cost_cells(s));
      if (!last || run.outcome != kStoppedRun) row.append(measured_at(s, start));
      rows.push_back(std::move(row));
    }
    if (!rows.empty()) return rows;
    rows.push_back(settings_);
    rows[0].append({{"time", ""}, {"outcome", run.outcome}, {"failure", run.failure}});
    return rows;
  }

 private:
  void require_times() const {
    for (const double t : options_.at)
      if (!(t >= 0 && t <= scene_.time.end * (1 + 1e-9)))
        throw InvalidInput(
            fmt::format("there is nothing to measure at the time {}: the scene is "
                        "from 0 to {}; give times between, or another time.end",
                        t, scene_.time.end));
  }

  bool is_exact() const {
    return scene_.measure.reference == "exact" || scene_.measure.reference == "polyhedron";
  }
  double tolerance() const {
    return scene_.measure.tolerance > 0 ? scene_.measure.tolerance
                                        : 1e-3 * scene_.tracker.cell_size;
  }

  /// Refuses a reference before the run, which would be lost if it were refused after it.
  void require_reference() const {
    if (scene_.measure.reference == "none") return;
    if (!is_exact()) return void(read_triangles(scene_.measure.reference));
    if (scene_.fluid)
      throw InvalidInput(scene_.file.string() +
                         ": a fluid moves this surface, and there is nothing exact to measure it "
                         "against; give --reference none, or a mesh");
    exact_carry(scene_, scene_.time.end, tolerance());  // refuses what is no velocity field
    // Paths err by a millionth of the tolerance, which must not be lost in rounding.
    constexpr double kLeast = 1e-9;
    double largest = 0;
    for (const Point& p : scene_.surface.positions)
      largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
    if (!(tolerance() >= kLeast * largest))
      throw InvalidInput(
          fmt::format("a reference's tolerance of {} is within rounding of "
                      "coordinates as large as {}; give {} or more",
                      tolerance(), largest, kLeast * largest));
  }

  Row measured_at(const Snapshot& s, const Triangles& start) {
    Row cells = shape_cells(s.surface, scene_);
    const std::string& reference = scene_.measure.reference;
    cells.set("reference", reference);
    if (is_exact()) {
      const Truth truth = truth_at(scene_, s.time, {reference, tolerance(), options_.references});
      cells.append(compare(s.surface, truth, options_.compare));
      cells.append(
          compare_markers(s.surface, start, exact_carry(scene_, s.time, 1e-6 * tolerance())));
    } else if (reference != "none") {
      Truth truth;
      truth.exact.surface = read_triangles(reference);
      truth.volume = volume(truth.exact.surface);
      cells.append(compare(s.surface, truth, options_.compare));
    }
    if (!options_.surfaces.empty() && !s.surface.triangles.empty()) {
      const fs::path file = options_.surfaces / fmt::format("{}.{:g}.ply", options_.name, s.time);
      write_triangles(file, s.surface);
      cells.set("surface", file.filename().string());
    }
    cells.set("fingerprint", fingerprint(s.surface));
    return cells;
  }

  const MeasurementOptions& options_;
  Scene scene_;
  Row settings_;
};

}  // namespace

std::vector<Row> measure(const MeasurementOptions& options, const std::string& command,
                         RunWatcher* watcher) {
  const Row settings = Work(options, command).settings();  // refuses what is bad
  const Ended ended = in_process({.jobs = 1, .limit_seconds = options.limit_seconds}, [&] {
    try {
      return packed(Work(options, command).all(watcher));
    } catch (const std::exception& error) {
      Row row = settings;
      row.append({{"time", ""}, {"outcome", kStoppedRun}, {"failure", error.what()}});
      return packed({row});
    }
  });
  if (ended.finished) return unpacked(ended.said);
  Row row = settings;
  row.append({{"time", ""},
              {"outcome", ended.out_of_time ? kTimedOutRun : kCrashedRun},
              {"failure", ended.words()},
              {"seconds", ended.cpu_seconds},
              {"peak_megabytes", ended.peak_megabytes}});
  return {row};
}

}  // namespace suture::sims
