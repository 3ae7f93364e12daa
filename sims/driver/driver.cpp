// The one loop that steps a surface: a simulator moves it, a tracker keeps it, watchers hear of it.
#include "sims/driver/driver.h"

#include <algorithm>

#include "kernel/errors.h"

namespace suture::sims {

Driver::Driver(SurfaceTracker& tracker, Simulator& simulator, const Schedule& schedule)
    : tracker_(tracker), simulator_(simulator), schedule_(schedule) {
  if (std::min({schedule.remodel_every, schedule.improve_every, schedule.end_every}) < 0)
    throw InvalidInput("remodel_every and improve_every count steps; give 0 (never) or more");
  if (!tracker.keeps_triangles() && (schedule.remodel_every > 0 || schedule.improve_every > 0))
    throw InvalidInput(
        "this way to track a surface keeps no mesh that could be remodelled or improved; schedule "
        "neither");
}

void Driver::frame(double end, StepWatcher& watcher, FrameIs which) {
  ++frames_;
  move_to(end, watcher);
  look_after(due(which), watcher);
}

Driver::Due Driver::due(FrameIs which) const {
  const auto now = [&](int every) {
    return every > 0 && (frames_ % every == 0 || which == FrameIs::last);
  };
  return {now(schedule_.remodel_every), now(schedule_.improve_every), now(schedule_.end_every)};
}

void Driver::move_to(double end, StepWatcher& watcher) {
  const Due whole{schedule_.remodel_every > 0, schedule_.improve_every > 0, true};
  int taken = 0;
  for (double left = end - tracker_.time(); left > 0;) {
    const int most = std::max(1, simulator_.most_steps() - taken++);
    const int steps = std::min(simulator_.steps_in(left), most);
    const double dt = left / steps;
    simulator_.step(tracker_, dt);
    watcher.moved(dt);
    left = steps == 1 ? 0 : end - tracker_.time();
    if (left > 0 && schedule_.end_every > 0 && tracker_.keeps_triangles() &&
        simulator_.wants_topology())
      look_after(whole, watcher);
  }
}

void Driver::look_after(const Due& due, StepWatcher& watcher) {
  if (!due.any()) return;
  simulator_.before_remodel(tracker_);
  if (due.remodel && !vanished()) {
    const SurgeryReport report = tracker_.remodel();
    watcher.remodelled(report);
    if (report.outcome == Outcome::committed)
      simulator_.surface_changed(tracker_.surface(), report.vertex_map);
  }
  if (due.improve && !vanished()) {
    const QualityReport report = tracker_.improve();
    watcher.improved(report);
    simulator_.surface_changed(tracker_.surface(), report.vertex_map);
  }
  if (due.end) tracker_.end_of_frame();
  simulator_.after_remodel(tracker_);
}

}  // namespace suture::sims
