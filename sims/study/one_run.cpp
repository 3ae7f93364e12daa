// One run of a scene for a study: its cost, and its error against the reference.
#include "sims/study/one_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/distance.h"
#include "kernel/measure/measures.h"
#include "sims/driver/scene_steps.h"
#include "sims/study/surface_measures.h"
#include "sims/study/table.h"
#include "sims/support/processes.h"

namespace suture::sims {
namespace {

using nlohmann::json;

/// CPU seconds of each part of the steps, and counts of what was done.
class Costs : public StepWatcher {
 public:
  explicit Costs(Row& row) : row_(row), last_(process_seconds()) {
    Figures& f = row.figures;
    for (double* x : {&f.remodel_seconds, &f.improve_seconds, &f.move_seconds, &f.remodels,
                      &f.surgeries, &f.refused, &f.steps, &f.triangles_mean, &f.triangles_max})
      *x = 0;
  }

  void moved(double /*dt*/) override { lap(row_.figures.move_seconds); }

  void remodelled(const SurgeryReport& r) override {
    Figures& f = row_.figures;
    lap(f.remodel_seconds);
    f.remodels += 1;
    f.surgeries += r.outcome == Outcome::committed ? 1 : 0;
    if (r.outcome != Outcome::refused) return;
    if (f.refused == 0) row_.failure = r.failure;
    f.refused += 1;
  }

  void improved(const QualityReport& /*report*/) override { lap(row_.figures.improve_seconds); }

  void stepped(const Triangles& surface) {
    Figures& f = row_.figures;
    const auto triangles = static_cast<double>(surface.triangles.size());
    f.steps += 1;
    f.triangles_mean += (triangles - f.triangles_mean) / f.steps;
    f.triangles_max = std::max(f.triangles_max, triangles);
    f.triangles_end = triangles;
    f.tracker_seconds = f.remodel_seconds + f.improve_seconds;
    f.total_seconds = f.tracker_seconds + f.move_seconds;
    f.peak_megabytes = peak_megabytes();
  }

 private:
  void lap(double& seconds) {
    const double now = process_seconds();
    seconds += now - last_;
    last_ = now;
  }

  Row& row_;
  double last_;
};

void measure_shape(const Triangles& surface, Figures& f) {
  const SurfaceMeasures m = measure_surface(surface);
  f.components = m.components;
  f.euler = m.euler;
  f.intersecting_pairs = m.intersecting_pairs;
  f.without_area = m.without_area;
  f.least_angle = m.least_angle;
}

void measure_error(const Triangles& surface, const OneRun& run, Figures& f) {
  const Triangles reference = read_triangles(run.reference);
  f.volume_error = volume(surface) / volume(reference) - 1;
  std::vector<std::int64_t> right = run.topology;
  if (right.empty())
    right = {static_cast<std::int64_t>(components(reference).count),
             euler_characteristic(reference)};
  f.topology_right = f.components == static_cast<double>(right.at(0)) &&
                     f.euler == static_cast<double>(right.at(1));
  const TwoWayDistance d = surface_distance(surface, reference, {.samples = run.samples});
  f.mean_forth = d.forth.mean;
  f.mean_back = d.back.mean;
  f.max_forth = d.forth.max;
  f.max_back = d.back.max;
}

void measure(const Triangles& surface, const Scene& scene, const OneRun& run, Row& row) {
  Figures& f = row.figures;
  f.volume_drift = volume(surface) / volume(scene.surface) - 1;
  if (surface.triangles.empty()) {
    f.components = f.euler = f.topology_right = 0;
    f.volume_error = -1;
    row.outcome = kStoppedRun;
    row.failure = "the surface has vanished: every part was thinner than a cell and split away";
    return;
  }
  measure_shape(surface, f);
  if (!run.reference.empty()) measure_error(surface, run, f);
  row.surface = fingerprint(surface);
  if (!run.surface.empty()) write_triangles(run.surface, surface);
}

void run_scene(const OneRun& run, Row& row) {
  Scene scene = read_scene(run.scene, run.changes);
  require_moved_mesh(scene);
  SceneSteps steps(scene);
  Costs costs(row);
  forget_peak();
  while (steps.more() && !steps.vanished()) {
    steps.step(costs);
    costs.stepped(steps.surface());
  }
  row.outcome = row.figures.refused > 0 ? kRefusedRun : kDoneRun;
  measure(steps.surface(), scene, run, row);
}

}  // namespace

Row run_once(const OneRun& run) {
  Row row;
  try {
    run_scene(run, row);
    return row;
  } catch (const std::bad_alloc&) {
    row.failure = "there is not enough memory for this";
  } catch (const std::exception& error) {
    row.failure = error.what();
  }
  if (row.figures.steps >= 0)  // the scene was read
    row.failure = fmt::format("step {}: {}", row.figures.steps + 1, row.failure);
  row.outcome = kStoppedRun;
  return row;
}

std::string packed(const Row& row) {
  json figures = json::array();
  for (const NamedFigure& f : kFigures) {
    const double x = row.figures.*f.figure;
    figures.push_back(std::isfinite(x) ? json(x) : json());
  }
  return json{{"outcome", row.outcome},
              {"failure", row.failure},
              {"surface", row.surface},
              {"figures", figures}}
      .dump(-1, ' ', true, json::error_handler_t::replace);
}

Row unpacked(const std::string& bytes) {
  const json j = json::parse(bytes);
  Row row;
  row.outcome = j.at("outcome");
  row.failure = j.at("failure");
  row.surface = j.at("surface");
  for (std::size_t i = 0; i < kFigures.size(); ++i)
    if (const json& x = j.at("figures").at(i); !x.is_null())
      row.figures.*kFigures[i].figure = x.get<double>();
  return row;
}

}  // namespace suture::sims
