// The order of a scene's steps: move, remodel, improve; who wants to know is told of each.
#include "sims/driver/driver.h"

#include <algorithm>

#include "kernel/errors.h"

namespace suture::sims {

double step_end(const TimeOptions& time, std::int64_t index) {
  return std::min(static_cast<double>(index) * time.step, time.end);
}

Motion& phase_at(Scene& scene, double time) {
  const double middle = time + 0.5 * scene.time.step;
  for (Phase& phase : scene.phases)
    if (middle < phase.until) return *phase.motion;
  return *scene.phases.back().motion;
}

Stepper::Stepper(Scene& scene, const TrackerOptions& options)
    : scene_(scene), tracker_(scene.surface, options) {
  if (scene.fluid)
    throw InvalidInput(scene.file.string() +
                       ": its surface is moved by a fluid, for which there is nothing exact to "
                       "compare with; run it by `suture run`");
  if (scene.method.kind != MethodKind::mesh)
    throw InvalidInput(scene.file.string() + ": the method \"" + method_name(scene.method.kind) +
                       "\" is no mesh as the tracker looks after it, which this needs; take the "
                       "table [method] out, or run the scene by `suture run`");
}

void Stepper::step(std::int64_t index, StepWatcher& watcher) {
  const TimeOptions& time = scene_.time;
  const double dt = step_end(time, index) - tracker_.time();
  phase_at(scene_, tracker_.time()).advance(tracker_, dt);
  watcher.moved(dt);
  const bool last = index == time.steps();
  if (time.remodel_every > 0 && (index % time.remodel_every == 0 || last)) {
    const SurgeryReport r = tracker_.remodel();
    watcher.remodelled(r);
    if (r.outcome == Outcome::committed) surface_changed(r.vertex_map);
  }
  if (time.improve_every > 0 && (index % time.improve_every == 0 || last) && !vanished()) {
    const QualityReport r = tracker_.improve();
    watcher.improved(r);
    surface_changed(r.vertex_map);
  }
}

void Stepper::surface_changed(const std::vector<std::uint32_t>& vertex_map) {
  for (Phase& phase : scene_.phases) phase.motion->surface_changed(tracker_.surface(), vertex_map);
}

}  // namespace suture::sims
