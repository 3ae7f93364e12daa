// One method on one scene, from start to end, with what it costs and its surface at given times.
#include "sims/accuracy/method_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/errors.h"
#include "kernel/measures.h"
#include "sims/processes.h"
#include "sims/rivals/method.h"
#include "sims/stepper.h"
#include "sims/trade/row.h"

namespace suture {
namespace {

/// A scene's steps, whatever moves its surface.
class Steps {
 public:
  virtual ~Steps() = default;
  virtual void step(std::int64_t index) = 0;
  virtual void settle() = 0;
  virtual const Triangles& surface() = 0;
  virtual double time() const = 0;
  virtual TrackerCost cost() const = 0;
};

/// The mesh tracker under a motion that its own surface decides.
class MeshSteps : public Steps, StepWatcher {
 public:
  explicit MeshSteps(Scene& scene) : stepper_(scene, scene.tracker) {}
  void step(std::int64_t index) override {
    if (stepper_.vanished()) return;
    last_ = process_seconds();
    stepper_.step(index, *this);
  }
  void settle() override {}
  const Triangles& surface() override { return stepper_.tracker().surface(); }
  double time() const override { return stepper_.tracker().time(); }
  TrackerCost cost() const override {
    return {{{"move", move_}, {"remodel", remodel_}, {"improve", improve_}},
            {{"remodels", remodels_},
             {"surgeries_committed", committed_},
             {"surgeries_refused", refused_},
             {"cells_resampled", cells_}}};
  }

 private:
  void lap(double& seconds) {
    const double now = process_seconds();
    seconds += now - last_;
    last_ = now;
  }
  void moved(double /*dt*/) override { lap(move_); }
  void improved(const QualityReport& /*report*/) override { lap(improve_); }
  void remodelled(const SurgeryReport& r) override {
    lap(remodel_);
    ++remodels_;
    committed_ += r.outcome == Outcome::committed;
    refused_ += r.outcome == Outcome::refused;
    if (r.outcome == Outcome::committed) cells_ += static_cast<double>(r.marked.total());
  }

  Stepper stepper_;
  double last_ = 0, move_ = 0, remodel_ = 0, improve_ = 0;
  double remodels_ = 0, committed_ = 0, refused_ = 0, cells_ = 0;
};

/// Any method under velocity fields.
class FieldSteps : public Steps {
 public:
  explicit FieldSteps(Scene& scene) : scene_(scene), tracker_(make_surface_tracker(scene)) {}
  void step(std::int64_t index) override {
    const TimeOptions& time = scene_.time;
    const double until = std::min(static_cast<double>(index) * time.step, time.end);
    tracker_->advect(*phase().motion->field(), until - tracker_->time());
  }
  void settle() override { tracker_->settle(); }
  const Triangles& surface() override { return tracker_->surface(); }
  double time() const override { return tracker_->time(); }
  TrackerCost cost() const override { return tracker_->cost(); }

 private:
  Phase& phase() {
    const double middle = tracker_->time() + 0.5 * scene_.time.step;
    for (Phase& phase : scene_.phases)
      if (middle < phase.until) return phase;
    return scene_.phases.back();
  }
  Scene& scene_;
  std::unique_ptr<SurfaceTracker> tracker_;
};

bool moved_by_fields(const Scene& scene) {
  return std::all_of(scene.phases.begin(), scene.phases.end(),
                     [](const Phase& p) { return p.motion->field() != nullptr; });
}

std::unique_ptr<Steps> make_steps(Scene& scene) {
  if (moved_by_fields(scene)) return std::make_unique<FieldSteps>(scene);
  const std::string& kind = scene.method.kind;
  if (kind == "mesh_without_topology" || kind == "markers") scene.time.remodel_every = 0;
  if (kind == "markers") scene.time.improve_every = 0;
  if (!keeps_a_mesh(scene.method.kind))
    throw InvalidInput(scene.file.string() +
                       ": the motion is decided by the surface's own vertices, which only the mesh "
                       "methods have; give --method mesh");
  return std::make_unique<MeshSteps>(scene);
}

class Measured {
 public:
  Measured(Scene& scene, std::vector<double> times, RunWatcher* watcher)
      : scene_(scene), times_(std::move(times)), watcher_(watcher) {
    std::sort(times_.begin(), times_.end());
  }

  MethodRun all() {
    try {
      forget_peak();
      const double start = process_seconds();
      steps_ = make_steps(scene_);
      now_.seconds = process_seconds() - start;
      go();
      const auto counts = steps_->cost().counts;
      const bool refused = std::any_of(counts.begin(), counts.end(), [](const auto& c) {
        return c.first == "surgeries_refused" && c.second > 0;
      });
      result_.outcome = refused ? kRefusedRun : kDoneRun;
      if (refused) result_.failure = "surgeries were refused";
    } catch (const std::bad_alloc&) {
      stop("there is not enough memory for this");
    } catch (const std::exception& error) {
      stop(error.what());
    }
    return std::move(result_);
  }

 private:
  void go() {
    const std::int64_t steps = scene_.time.steps();
    const bool mesh = keeps_a_mesh(scene_.method.kind);
    std::size_t next = 0;
    while (next < times_.size() && times_[next] <= 0) snap(next++);
    for (std::int64_t i = 1; i <= steps && next < times_.size(); ++i) {
      timed([&] { steps_->step(i); });
      now_.steps += 1;
      if (mesh) count();
      const double reached = steps_->time() + 1e-9 * scene_.time.step;
      const bool over = mesh && grown_together();
      if (reached >= times_[next] || i == steps || over) {
        timed([&] { steps_->settle(); });
        while (next < times_.size() && (reached >= times_[next] || i == steps || over))
          snap(next++);
      }
      tell(i, steps, mesh);
      if (over) return;
    }
  }

  template <class F>
  void timed(const F& work) {
    const double start = process_seconds();
    work();
    now_.seconds += process_seconds() - start;
  }

  bool grown_together() {
    const auto most = static_cast<std::size_t>(scene_.measure.until_components);
    return most > 0 && components(steps_->surface()).count <= most;
  }

  void count() {
    const auto triangles = static_cast<double>(steps_->surface().triangles.size());
    counted_ += 1;
    now_.triangles_mean += (triangles - now_.triangles_mean) / counted_;
    now_.triangles_max = std::max(now_.triangles_max, triangles);
  }

  void snap(std::size_t /*which*/) {
    timed([&] { now_.surface = steps_->surface(); });
    if (!keeps_a_mesh(scene_.method.kind)) count();
    now_.time = steps_->time();
    now_.cost = steps_->cost();
    now_.peak_megabytes = peak_megabytes();
    result_.snapshots.push_back(now_);
  }

  void tell(std::int64_t i, std::int64_t steps, bool mesh) {
    if (watcher_ == nullptr) return;
    const std::size_t triangles = mesh ? steps_->surface().triangles.size() : 0;
    watcher_->stepped({i, steps, steps_->time(), triangles, 0});
  }

  void stop(const std::string& why) {
    result_.outcome = kStoppedRun;
    result_.failure = steps_ ? fmt::format("step {}: {}", now_.steps + 1, why) : why;
    if (!steps_) return;
    now_.time = steps_->time();
    now_.cost = steps_->cost();
    now_.peak_megabytes = peak_megabytes();
    now_.surface = {};
    result_.snapshots.push_back(now_);
  }

  Scene& scene_;
  std::vector<double> times_;
  RunWatcher* watcher_;
  std::unique_ptr<Steps> steps_;
  Snapshot now_;
  double counted_ = 0;
  MethodRun result_;
};

}  // namespace

MethodRun run_method(Scene& scene, std::vector<double> times, RunWatcher* watcher) {
  return Measured(scene, std::move(times), watcher).all();
}

}  // namespace suture
