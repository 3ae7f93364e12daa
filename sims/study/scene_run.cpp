// A scene run from start to end by whatever tracks its surface: the surface and all costs at times.
#include "sims/study/scene_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "sims/driver/method_stepper.h"
#include "sims/study/table/row.h"
#include "sims/support/clock.h"

namespace suture::sims {
namespace {

/// Whether the surface is a mesh at all times, and asking for it costs nothing.
bool has_a_mesh(const Scene& scene) {
  return scene.method.is_mesh() || scene.method.kind == MethodKind::semi_lagrangian_contouring;
}

/// Costs of each part of the steps, as it ends, and why surgery was refused first.
class Watch : public StepWatcher {
 public:
  void begin() { lap_.next(); }
  const Costs& costs() const { return costs_; }
  const std::string& refusal() const { return refusal_; }

 private:
  void moved(double /*dt*/) override { costs_.add_seconds("move", lap_.next()); }

  void remodelled(const SurgeryReport& r) override {
    costs_.add_seconds("remodel", lap_.next());
    costs_.count("remodels");
    if (r.outcome == Outcome::refused) {
      if (costs_.count_of("surgeries_refused") == 0) refusal_ = r.failure;
      costs_.count("surgeries_refused");
    } else if (r.outcome == Outcome::committed) {
      costs_.count("surgeries_committed");
      costs_.count("cells_resampled", static_cast<double>(r.marked.total()));
    }
  }

  void improved(const QualityReport& r) override {
    costs_.add_seconds("improve", lap_.next());
    costs_.count("subdivisions", static_cast<double>(r.subdivisions));
    costs_.count("collapses", static_cast<double>(r.collapses.done));
    costs_.count("flips", static_cast<double>(r.flips));
  }

  Lap lap_;
  std::string refusal_;
  Costs costs_{{{"move", 0}, {"remodel", 0}, {"improve", 0}},
               {{"remodels", 0},
                {"surgeries_committed", 0},
                {"surgeries_refused", 0},
                {"cells_resampled", 0},
                {"subdivisions", 0},
                {"collapses", 0},
                {"flips", 0}}};
};

/// A run as it goes.
class Running {
 public:
  Running(Scene& scene, std::vector<double> times, RunWatcher* watcher)
      : scene_(scene), times_(std::move(times)), watcher_(watcher) {
    std::sort(times_.begin(), times_.end());
  }

  SceneRun all() {
    try {
      forget_peak();
      timed([&] { steps_ = make_steps(scene_, scene_.tracker); });
      go();
      const bool refused = costs().count_of("surgeries_refused") > 0;
      result_.outcome = refused ? kRefusedRun : kDoneRun;
      if (refused) result_.failure = "surgeries were refused";
    } catch (const std::bad_alloc&) {
      stop("there is not enough memory for this");
    } catch (const std::exception& error) {
      stop(error.what());
    }
    result_.refusal = watch_.refusal();
    return std::move(result_);
  }

 private:
  void go() {
    const std::int64_t steps = scene_.time.steps();
    const bool mesh = has_a_mesh(scene_);
    std::size_t next = 0;
    for (; next < times_.size() && times_[next] <= 0; ++next) snap();
    for (std::int64_t i = 1; i <= steps && next < times_.size(); ++i) {
      timed([&] {
        watch_.begin();
        steps_->step(i, watch_);
      });
      now_.steps += 1;
      if (mesh) count();
      const bool gone = mesh && steps_->vanished(), over = gone || (mesh && grown_together());
      const double reached = steps_->time() + 1e-9 * scene_.time.step;
      for (; next < times_.size() && (reached >= times_[next] || i == steps || over); ++next) {
        snap();
        // Nothing is left at all later times either.
        if (gone) result_.snapshots.back().time = std::max(times_[next], steps_->time());
      }
      tell(i);
      if (gone) result_.failure = fmt::format("nothing was left at t = {:g}", steps_->time());
      if (over) break;
    }
  }

  Costs costs() const {
    const Costs own = steps_->cost();
    return own.seconds.empty() ? watch_.costs() : own;
  }

  template <class F>
  void timed(const F& work) {
    const Lap lap;
    work();
    now_.seconds += lap.seconds();
  }

  bool grown_together() {
    const auto most = static_cast<std::size_t>(scene_.measure.until_components);
    return most > 0 && components(steps_->surface()).count <= most;
  }

  void count() {
    now_.triangles = static_cast<double>(steps_->surface().triangles.size());
    counted_ += 1;
    now_.triangles_mean += (now_.triangles - now_.triangles_mean) / counted_;
    now_.triangles_max = std::max(now_.triangles_max, now_.triangles);
  }

  void snap() {
    timed([&] { now_.surface = steps_->surface(); });
    if (!has_a_mesh(scene_)) count();
    keep();
  }

  /// Keeps what is known now.
  void keep() {
    now_.time = steps_->time();
    now_.costs = costs();
    now_.peak_megabytes = peak_megabytes();
    result_.snapshots.push_back(now_);
  }

  void tell(std::int64_t step) {
    if (watcher_ == nullptr) return;
    const std::size_t triangles = has_a_mesh(scene_) ? steps_->surface().triangles.size() : 0;
    watcher_->stepped({step, scene_.time.steps(), steps_->time(), triangles, 0});
  }

  void stop(const std::string& why) {
    result_.outcome = kStoppedRun;
    result_.failure = steps_ ? fmt::format("step {}: {}", now_.steps + 1, why) : why;
    if (!steps_) return;
    now_.surface = {};
    keep();
  }

  Scene& scene_;
  std::vector<double> times_;
  RunWatcher* watcher_;
  std::unique_ptr<Steps> steps_;
  Watch watch_;
  Snapshot now_;
  double counted_ = 0;
  SceneRun result_;
};

}  // namespace

void require_tracked_mesh(const Scene& scene) {
  if (scene.fluid)
    throw InvalidInput(scene.file.string() +
                       ": its surface is moved by a fluid, for which there is nothing exact to "
                       "compare with; run it by `suture run`");
  if (scene.method.kind != MethodKind::mesh)
    throw InvalidInput(scene.file.string() + ": the method \"" + method_name(scene.method.kind) +
                       "\" is no mesh as the tracker looks after it, which this needs; take the "
                       "table [method] out, or run the scene by `suture run`");
}

SceneRun run_scene(Scene& scene, std::vector<double> times, RunWatcher* watcher) {
  return Running(scene, std::move(times), watcher).all();
}

}  // namespace suture::sims
