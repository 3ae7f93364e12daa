// A scene run by a method and measured: what `suture measure` does.
#include "sims/study/measurement.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/measures.h"
#include "sims/study/scene_run.h"
#include "sims/study/settings.h"
#include "sims/study/surface_measures.h"
#include "sims/study/table/trade_row.h"

namespace suture::sims {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

void add(Record& to, const Record& more) { to.insert(to.end(), more.begin(), more.end()); }

std::string changes_in_words(const SceneChanges& changes) {
  std::string words;
  for (const auto& [name, value] : changes)
    words += (words.empty() ? "" : " ") + name + "=" + text_of(value);
  return words;
}

/// What was asked for: the first columns.
Record setting_cells(const Scene& scene, const SceneChanges& changes, const std::string& command) {
  const TrackerOptions& t = scene.tracker;
  const double edge = t.quality.edge_length > 0 ? t.quality.edge_length : t.cell_size;
  const double domain = scene.measure.domain;
  return {{"scene", scene.file.stem().string()},
          {"method", method_name(scene.method.kind)},
          {"resolution", domain > 0 ? cell_of(domain / t.cell_size) : ""},
          {"cell_size", cell_of(t.cell_size)},
          {"edge_length", cell_of(edge)},
          {"time_step", cell_of(scene.time.step)},
          {"topology_interval", std::to_string(scene.time.remodel_every)},
          {"improve_interval", std::to_string(scene.time.improve_every)},
          {"start_triangles", std::to_string(scene.surface.triangles.size())},
          {"changes", changes_in_words(changes)},
          {"command", command}};
}

double count_of(const TrackerCost& cost, const std::string& name) {
  for (const auto& [key, value] : cost.counts)
    if (key == name) return value;
  return kUnknownFigure;
}

std::string in_words(const std::vector<std::pair<std::string, double>>& parts) {
  std::string words;
  for (const auto& [name, value] : parts)
    words += fmt::format("{}{}={:.6g}", words.empty() ? "" : " ", name, value);
  return words;
}

Record cost_cells(const Snapshot& s) {
  const double work = 1e-6 * s.triangles_mean * s.steps;
  return {
      {"steps", cell_of(s.steps)},
      {"seconds", cell_of(s.seconds)},
      {"seconds_per_million_triangle_steps", cell_of(work > 0 ? s.seconds / work : kUnknownFigure)},
      {"seconds_by_part", in_words(s.cost.seconds)},
      {"peak_megabytes", cell_of(s.peak_megabytes)},
      {"triangles", std::to_string(s.surface.triangles.size())},
      {"triangles_mean", cell_of(s.triangles_mean)},
      {"triangles_max", cell_of(s.triangles_max)},
      {"cells_resampled", cell_of(count_of(s.cost, "cells_resampled"))},
      {"surgeries", cell_of(count_of(s.cost, "surgeries_committed"))},
      {"refused", cell_of(count_of(s.cost, "surgeries_refused"))},
      {"counts", in_words(s.cost.counts)}};
}

Record shape_cells(const Triangles& surface, const Scene& scene) {
  const bool as_at_first = scene.measure.reference != "none";
  const auto expected = [&](const std::optional<int>& given, std::int64_t own) {
    return given ? std::to_string(*given) : as_at_first ? std::to_string(own) : "";
  };
  const SurfaceMeasures m = measure_surface(surface);
  const double v = volume(surface);
  return {
      {"components", cell_of(m.components)},
      {"components_expected", expected(scene.measure.components,
                                       static_cast<std::int64_t>(components(scene.surface).count))},
      {"euler", cell_of(m.euler)},
      {"euler_expected", expected(scene.measure.euler, euler_characteristic(scene.surface))},
      {"closed_manifold", audit(surface).closed_manifold() ? "yes" : "no"},
      {"self_intersecting_pairs", cell_of(m.intersecting_pairs)},
      {"triangles_without_area", cell_of(m.without_area)},
      {"least_angle", cell_of(m.least_angle)},
      {"volume", cell_of(v)},
      {"volume_drift", cell_of(v / volume(scene.surface) - 1)}};
}

/// One run and its measuring, in the process that was made for it.
class Work {
 public:
  Work(const MeasurementOptions& options, const std::string& command)
      : options_(options), scene_(read_scene(options.scene, options.changes)) {
    settings_ = setting_cells(scene_, options.changes, command);
    settings_.insert(settings_.begin(), {"run", options.name});
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

  const Record& settings() const { return settings_; }

  std::vector<Record> all(RunWatcher* watcher) {
    const Triangles start = scene_.surface;
    const MethodRun run = run_method(scene_, times(), watcher);
    std::vector<Record> rows;
    for (const Snapshot& s : run.snapshots) {
      Record row = settings_;
      const bool last = &s == &run.snapshots.back();
      add(row, {{"time", cell_of(s.time)},
                {"outcome", last ? run.outcome : "done"},
                {"failure", last ? run.failure : ""}});
      add(row, cost_cells(s));
      if (!last || run.outcome != kStoppedRun) add(row, measured_at(s, start));
      rows.push_back(std::move(row));
    }
    if (!rows.empty()) return rows;
    rows.push_back(settings_);
    add(rows[0], {{"time", ""}, {"outcome", run.outcome}, {"failure", run.failure}});
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

  /// What is found wrong with a reference only after the run would have cost it.
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

  Record measured_at(const Snapshot& s, const Triangles& start) {
    Record cells = shape_cells(s.surface, scene_);
    const std::string& reference = scene_.measure.reference;
    cells.emplace_back("reference", reference);
    if (is_exact()) {
      const Truth truth = truth_at(scene_, s.time, {reference, tolerance(), options_.references});
      add(cells, compare(s.surface, truth, options_.compare));
      add(cells,
          compare_markers(s.surface, start, exact_carry(scene_, s.time, 1e-6 * tolerance())));
    } else if (reference != "none") {
      Truth truth;
      truth.exact.surface = read_triangles(reference);
      truth.volume = volume(truth.exact.surface);
      add(cells, compare(s.surface, truth, options_.compare));
    }
    if (!options_.surfaces.empty() && !s.surface.triangles.empty()) {
      const fs::path file = options_.surfaces / fmt::format("{}.{:g}.ply", options_.name, s.time);
      write_triangles(file, s.surface);
      cells.emplace_back("surface", file.filename().string());
    }
    cells.emplace_back("fingerprint", fingerprint(s.surface));
    return cells;
  }

  const MeasurementOptions& options_;
  Scene scene_;
  Record settings_;
};

std::string packed_rows(const std::vector<Record>& rows) {
  return json(rows).dump(-1, ' ', true, json::error_handler_t::replace);
}

}  // namespace

std::vector<Record> measure(const MeasurementOptions& options, const std::string& command,
                            RunWatcher* watcher) {
  const Record settings = Work(options, command).settings();  // refuses what is bad
  std::vector<Record> rows;
  in_processes(
      {0}, {.jobs = 1, .limit_seconds = options.limit_seconds},
      [&](std::size_t) {
        try {
          return packed_rows(Work(options, command).all(watcher));
        } catch (const std::exception& error) {
          Record row = settings;
          add(row, {{"time", ""}, {"outcome", kStoppedRun}, {"failure", error.what()}});
          return packed_rows({row});
        }
      },
      [&](std::size_t, const Ended& ended) {
        if (ended.finished) {
          rows = json::parse(ended.said).get<std::vector<Record>>();
          return;
        }
        Record row = settings;
        add(row, {{"time", ""},
                  {"outcome", ended.out_of_time ? kTimedOutRun : kCrashedRun},
                  {"failure", ended.words()},
                  {"seconds", cell_of(ended.cpu_seconds)},
                  {"peak_megabytes", cell_of(ended.peak_megabytes)}});
        rows.push_back(std::move(row));
      });
  return rows;
}

}  // namespace suture::sims
