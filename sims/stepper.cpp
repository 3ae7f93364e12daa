// The order of a scene's steps: move, remodel, improve; who wants to know is told of each.
#include "sims/stepper.h"

#include <algorithm>

namespace suture {

void Stepper::step(std::int64_t index, StepWatcher& watcher) {
  const TimeOptions& time = scene_.time;
  const double until = std::min(static_cast<double>(index) * time.step, time.end);
  const double dt = until - tracker_.time();
  phase().advance(tracker_, dt);
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

Motion& Stepper::phase() {
  const double middle = tracker_.time() + 0.5 * scene_.time.step;
  for (Phase& phase : scene_.phases)
    if (middle < phase.until) return *phase.motion;
  return *scene_.phases.back().motion;
}

void Stepper::surface_changed(const std::vector<std::uint32_t>& vertex_map) {
  for (Phase& phase : scene_.phases) phase.motion->surface_changed(tracker_.surface(), vertex_map);
}

}  // namespace suture
