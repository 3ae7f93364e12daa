// A run of a scene for a trade study: its cost, and its error against the reference.
#include "sims/study/trade_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/distance.h"
#include "kernel/measure/measures.h"
#include "sims/driver/scene_steps.h"
#include "sims/study/scene_run.h"
#include "sims/study/surface_measures.h"
#include "sims/study/table/trade_row.h"
#include "sims/support/fingerprint.h"

namespace suture::sims {
namespace {

/// A figure; what is not finite is not known.
void set(Row& row, const char* figure, double x) {
  row.set(figure, std::isfinite(x) ? x : kUnknown);
}

/// Sets what was spent until a run's last step. Some of it is known only where there was a step.
void set_costs(Row& row, const Snapshot& end) {
  const Costs& c = end.costs;
  const double remodel = c.seconds_of("remodel"), improve = c.seconds_of("improve"),
               move = c.seconds_of("move");
  set(row, "remodel_seconds", remodel);
  set(row, "improve_seconds", improve);
  set(row, "move_seconds", move);
  set(row, "triangles_mean", end.triangles_mean);
  set(row, "triangles_max", end.triangles_max);
  set(row, "steps", end.steps);
  set(row, "remodels", c.count_of("remodels"));
  set(row, "surgeries", c.count_of("surgeries_committed"));
  set(row, "refused", c.count_of("surgeries_refused"));
  if (!(end.steps > 0)) return;
  set(row, "tracker_seconds", remodel + improve);
  set(row, "total_seconds", remodel + improve + move);
  set(row, "peak_megabytes", end.peak_megabytes);
  set(row, "triangles_end", end.triangles);
}

void set_shape(Row& row, const Triangles& surface) {
  const SurfaceMeasures m = measure_surface(surface);
  set(row, "components", m.components);
  set(row, "euler", m.euler);
  set(row, "self_intersecting_pairs", m.intersecting_pairs);
  set(row, "triangles_without_area", m.without_area);
  set(row, "least_angle", m.least_angle);
}

void set_error(Row& row, const Triangles& surface, const TradeRun& run) {
  const Triangles reference = read_triangles(run.reference);
  set(row, "volume_error", volume(surface) / volume(reference) - 1);
  std::vector<std::int64_t> right = run.topology;
  if (right.empty())
    right = {static_cast<std::int64_t>(components(reference).count),
             euler_characteristic(reference)};
  const bool topology_right = row.number("components") == static_cast<double>(right.at(0)) &&
                              row.number("euler") == static_cast<double>(right.at(1));
  set(row, "topology_right", topology_right ? 1 : 0);
  const TwoWayDistance d = surface_distance(surface, reference, {.samples = run.samples});
  set(row, "mean_distance_forth", d.forth.mean);
  set(row, "mean_distance_back", d.back.mean);
  set(row, "max_distance_forth", d.forth.max);
  set(row, "max_distance_back", d.back.max);
}

void set_vanished(Row& row) {
  for (const char* figure : {"components", "euler", "topology_right"}) set(row, figure, 0);
  set(row, "volume_error", -1);
  row.set("outcome", kStoppedRun);
  row.set("failure", "the surface has vanished: every part was thinner than a cell and split away");
}

void measure(Row& row, const Triangles& surface, const TradeRun& run) {
  if (surface.triangles.empty()) return set_vanished(row);
  set_shape(row, surface);
  if (!run.reference.empty()) set_error(row, surface, run);
  row.set("surface", fingerprint(surface));
  if (!run.surface.empty()) write_triangles(run.surface, surface);
}

/// The scene to its end, as only the tracker's mesh goes there.
Scene read_whole(const TradeRun& run) {
  Scene scene = read_scene(run.scene, run.changes);
  require_moved_mesh(scene);
  scene.measure.until_components = 0;
  return scene;
}

void run_and_measure(Row& row, const TradeRun& run) {
  Scene scene = read_whole(run);
  const double first_volume = volume(scene.surface);
  const SceneRun made = run_scene(scene, {scene.time.end});
  row.set("outcome", made.outcome);
  row.set("failure", made.outcome == kRefusedRun ? made.refusal : made.failure);
  if (made.snapshots.empty()) return;
  const Snapshot& end = made.snapshots.back();
  set_costs(row, end);
  if (made.outcome == kStoppedRun) return;
  row.set("failure", made.refusal);
  set(row, "volume_drift", volume(end.surface) / first_volume - 1);
  measure(row, end.surface, run);
}

}  // namespace

Row run_once(const TradeRun& run) {
  Row row{{"outcome", ""}, {"failure", ""}};
  for (const char* figure : kFigures) row.set(figure, kUnknown);
  row.set("surface", "");
  std::string failure;
  try {
    run_and_measure(row, run);
    return row;
  } catch (const std::bad_alloc&) {
    failure = "there is not enough memory for this";
  } catch (const std::exception& error) {
    failure = error.what();
  }
  const double steps = row.number("steps");
  row.set("failure", steps >= 0 ? fmt::format("step {}: {}", steps + 1, failure) : failure);
  row.set("outcome", kStoppedRun);
  return row;
}

}  // namespace suture::sims
