// A scene run from start to end by whatever tracks its surface: the surface and all costs at times.
#include "sims/study/scene_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "sims/driver/scene_steps.h"
#include "sims/study/table/row.h"

namespace suture::sims {
namespace {

/// \return whether the surface is a mesh at all times, so that asking for it costs nothing
bool has_a_mesh(const Scene& scene) {
  return scene.method.is_mesh() || scene.method.kind == MethodKind::semi_lagrangian_contouring;
}

/// Hears why surgery was refused first.
class FirstRefusal : public StepWatcher {
 public:
  const std::string& words() const { return words_; }

 private:
  void remodelled(const SurgeryReport& r) override {
    if (r.outcome == Outcome::refused && !std::exchange(refused_, true)) words_ = r.failure;
  }

  bool refused_ = false;
  std::string words_;
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
      timed([&] { steps_.emplace(scene_); });
      go();
      const bool refused = steps_->cost().count_of("surgeries_refused") > 0;
      result_.outcome = refused ? kRefusedRun : kDoneRun;
      if (refused) result_.failure = "surgeries were refused";
    } catch (const std::bad_alloc&) {
      stop("there is not enough memory for this");
    } catch (const std::exception& error) {
      stop(error.what());
    }
    result_.refusal = refusal_.words();
    return std::move(result_);
  }

 private:
  void go() {
    const bool mesh = has_a_mesh(scene_);
    std::size_t next = 0;
    for (; next < times_.size() && times_[next] <= 0; ++next) snap();
    while (steps_->more() && next < times_.size()) {
      timed([&] { steps_->step(refusal_); });
      now_.steps += 1;
      if (mesh) count();
      const bool gone = mesh && steps_->vanished(), over = gone || (mesh && grown_together());
      const double reached = steps_->time() + 1e-9 * scene_.time.step;
      const bool end = over || !steps_->more();
      for (; next < times_.size() && (reached >= times_[next] || end); ++next) {
        snap();
        // Nothing is left at all later times either.
        if (gone) result_.snapshots.back().time = std::max(times_[next], steps_->time());
      }
      tell();
      if (gone) result_.failure = fmt::format("nothing was left at t = {:g}", steps_->time());
      if (over) break;
    }
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
    now_.costs = steps_->cost();
    now_.peak_megabytes = peak_megabytes();
    result_.snapshots.push_back(now_);
  }

  void tell() {
    if (watcher_ == nullptr) return;
    const std::size_t triangles = has_a_mesh(scene_) ? steps_->surface().triangles.size() : 0;
    watcher_->stepped({steps_->index(), scene_.time.steps(), steps_->time(), triangles, 0});
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
  std::optional<SceneSteps> steps_;
  FirstRefusal refusal_;
  Snapshot now_;
  double counted_ = 0;
  SceneRun result_;
};

}  // namespace

SceneRun run_scene(Scene& scene, std::vector<double> times, RunWatcher* watcher) {
  return Running(scene, std::move(times), watcher).all();
}

}  // namespace suture::sims
