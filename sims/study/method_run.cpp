// One method on one scene, from start to end, with what it costs and its surface at given times.
#include "sims/study/method_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "sims/driver/scene_steps.h"
#include "sims/study/row.h"
#include "sims/support/processes.h"

namespace suture::sims {
namespace {

/// Whether the surface is a mesh at all times, and asking for it costs nothing.
bool has_a_mesh(const Scene& scene) {
  return scene.method.is_mesh() || scene.method.kind == MethodKind::semi_lagrangian_contouring;
}

/// CPU seconds of each part of the steps and counts of what was done, as the Stepper tells of them.
class Watch : public StepWatcher {
 public:
  void begin() { last_ = process_seconds(); }
  TrackerCost cost() const {
    return {{{"move", move_}, {"remodel", remodel_}, {"improve", improve_}},
            {{"remodels", remodels_},
             {"surgeries_committed", committed_},
             {"surgeries_refused", refused_},
             {"cells_resampled", cells_},
             {"subdivisions", subdivisions_},
             {"collapses", collapses_},
             {"flips", flips_}}};
  }

 private:
  void lap(double& seconds) {
    const double now = process_seconds();
    seconds += now - last_;
    last_ = now;
  }
  void moved(double /*dt*/) override { lap(move_); }
  void remodelled(const SurgeryReport& r) override {
    lap(remodel_);
    ++remodels_;
    committed_ += r.outcome == Outcome::committed;
    refused_ += r.outcome == Outcome::refused;
    if (r.outcome == Outcome::committed) cells_ += static_cast<double>(r.marked.total());
  }
  void improved(const QualityReport& r) override {
    lap(improve_);
    subdivisions_ += static_cast<double>(r.subdivisions);
    collapses_ += static_cast<double>(r.collapses.done);
    flips_ += static_cast<double>(r.flips);
  }

  double last_ = 0, move_ = 0, remodel_ = 0, improve_ = 0;
  double remodels_ = 0, committed_ = 0, refused_ = 0, cells_ = 0;
  double subdivisions_ = 0, collapses_ = 0, flips_ = 0;
};

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
      steps_ = std::make_unique<SceneSteps>(scene_);
      now_.seconds = process_seconds() - start;
      go();
      const auto counts = cost().counts;
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
    const bool mesh = has_a_mesh(scene_);
    std::size_t next = 0;
    for (; next < times_.size() && times_[next] <= 0; ++next) snap();
    while (steps_->more() && next < times_.size()) {
      timed([&] {
        watch_.begin();
        steps_->step(watch_);
      });
      const std::int64_t i = steps_->index();
      now_.steps += 1;
      if (mesh) count();
      const double reached = steps_->time() + 1e-9 * scene_.time.step;
      const bool gone = mesh && steps_->vanished(), over = gone || (mesh && grown_together());
      while (next < times_.size() && (reached >= times_[next] || i == steps || over)) {
        snap();
        // Nothing is left at all later times either.
        if (gone) result_.snapshots.back().time = std::max(times_[next], steps_->time());
        ++next;
      }
      tell(i, steps, mesh);
      if (gone) result_.failure = fmt::format("nothing was left at t = {:g}", steps_->time());
      if (over) break;
    }
  }

  TrackerCost cost() const {
    const TrackerCost own = steps_->cost();
    return own.seconds.empty() ? watch_.cost() : own;
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

  void snap() {
    timed([&] { now_.surface = steps_->surface(); });
    if (!has_a_mesh(scene_)) count();
    now_.time = steps_->time();
    now_.cost = cost();
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
    now_.cost = cost();
    now_.peak_megabytes = peak_megabytes();
    now_.surface = {};
    result_.snapshots.push_back(now_);
  }

  Scene& scene_;
  std::vector<double> times_;
  RunWatcher* watcher_;
  std::unique_ptr<SceneSteps> steps_;
  Watch watch_;
  Snapshot now_;
  double counted_ = 0;
  MethodRun result_;
};

}  // namespace

MethodRun run_method(Scene& scene, std::vector<double> times, RunWatcher* watcher) {
  return Measured(scene, std::move(times), watcher).all();
}

}  // namespace suture::sims
