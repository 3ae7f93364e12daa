// The mesh tracker behind the interface that its rivals have too.
#include "sims/tracking/mesh_tracker.h"

#include <optional>
#include <string>

#include "kernel/errors.h"
#include "kernel/measure/signed_distance.h"
#include "sims/support/clock.h"

namespace suture::sims {
namespace {

class MeshTracker : public SurfaceTracker {
 public:
  MeshTracker(Triangles surface, const TrackerOptions& options, const MeshSchedule& schedule)
      : tracker_(std::move(surface), options), schedule_(schedule) {
    if (schedule.remodel_every < 0 || schedule.improve_every < 0)
      throw InvalidInput("remodel_every and improve_every count steps; give 0 (never) or more");
  }

  void advect(const VelocityField& u, double dt) override {
    if (vanished()) {
      gone_for_ += dt;
      return;
    }
    distance_.reset();
    costs_.timed("move", [&] { tracker_.advect(u, dt); });
    remodelled_ = improved_ = false;
    ++steps_;
    if (due(schedule_.remodel_every)) remodel();
    if (due(schedule_.improve_every)) improve();
  }

  void displace(std::vector<Point> positions) override {
    if (vanished()) return;
    distance_.reset();
    tracker_.displace(std::move(positions));
    remodelled_ = improved_ = false;
  }

  void settle() override {
    if (schedule_.remodel_every > 0 && !remodelled_) remodel();
    if (schedule_.improve_every > 0 && !improved_) improve();
  }

  const Triangles& surface() override { return tracker_.surface(); }

  double distance(const Point& p) override {
    if (!distance_) distance_.emplace(tracker_.surface());
    return distance_->at(p);
  }

  bool keeps_triangles() const override {
    const auto idle = [](int every) { return every == 0 || every == kWhenItSettles; };
    return idle(schedule_.remodel_every) && idle(schedule_.improve_every);
  }
  void watch(StepWatcher* watcher) override { watcher_ = watcher; }
  double time() const override { return tracker_.time() + gone_for_; }

  TrackerCost cost() const override { return costs_; }

 private:
  bool due(int every) const { return every > 0 && steps_ % every == 0; }
  bool vanished() const { return tracker_.surface().triangles.empty(); }

  void remodel() {
    if (vanished()) return;
    distance_.reset();
    const SurgeryReport report = costs_.timed("remodel", [&] { return tracker_.remodel(); });
    remodelled_ = true;
    costs_.count("remodels");
    if (report.outcome == Outcome::refused) costs_.count("surgeries_refused");
    if (watcher_ != nullptr) watcher_->remodelled(report);
    if (report.outcome != Outcome::committed) return;
    improved_ = false;
    costs_.count("surgeries_committed");
    costs_.count("cells_resampled", static_cast<double>(report.marked.total()));
  }

  void improve() {
    if (vanished()) return;
    distance_.reset();
    const QualityReport report = costs_.timed("improve", [&] { return tracker_.improve(); });
    improved_ = true;
    costs_.count("subdivisions", static_cast<double>(report.subdivisions));
    costs_.count("collapses", static_cast<double>(report.collapses.done));
    costs_.count("flips", static_cast<double>(report.flips));
    if (watcher_ != nullptr) watcher_->improved(report);
  }

  Tracker tracker_;
  MeshSchedule schedule_;
  std::optional<SignedDistance> distance_;  ///< of the surface as it is, once it was asked for
  std::int64_t steps_ = 0;
  StepWatcher* watcher_ = nullptr;
  double gone_for_ = 0;                         ///< time since nothing was left
  bool remodelled_ = false, improved_ = false;  ///< since the last move
  Costs costs_{{{"move", 0}, {"remodel", 0}, {"improve", 0}},
               {{"remodels", 0},
                {"surgeries_committed", 0},
                {"surgeries_refused", 0},
                {"cells_resampled", 0},
                {"subdivisions", 0},
                {"collapses", 0},
                {"flips", 0}}};
};

}  // namespace

std::unique_ptr<SurfaceTracker> make_mesh_tracker(Triangles surface, const TrackerOptions& options,
                                                  const MeshSchedule& schedule) {
  return std::make_unique<MeshTracker>(std::move(surface), options, schedule);
}

}  // namespace suture::sims
