// The mesh tracker behind the interface that its rivals have too.
#include "sims/tracking/mesh_tracker.h"

#include <optional>
#include <string>

#include "kernel/errors.h"
#include "kernel/measure/signed_distance.h"
#include "sims/support/process_pool.h"

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
    const double start = process_seconds();
    tracker_.advect(u, dt);
    move_ += process_seconds() - start;
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

  TrackerCost cost() const override {
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
  bool due(int every) const { return every > 0 && steps_ % every == 0; }
  bool vanished() const { return tracker_.surface().triangles.empty(); }

  void remodel() {
    if (vanished()) return;
    distance_.reset();
    const double start = process_seconds();
    const SurgeryReport report = tracker_.remodel();
    remodel_ += process_seconds() - start;
    remodelled_ = true;
    ++remodels_;
    committed_ += report.outcome == Outcome::committed;
    refused_ += report.outcome == Outcome::refused;
    if (watcher_ != nullptr) watcher_->remodelled(report);
    if (report.outcome != Outcome::committed) return;
    improved_ = false;
    cells_ += static_cast<double>(report.marked.total());
  }

  void improve() {
    if (vanished()) return;
    distance_.reset();
    const double start = process_seconds();
    const QualityReport report = tracker_.improve();
    improve_ += process_seconds() - start;
    improved_ = true;
    subdivisions_ += static_cast<double>(report.subdivisions);
    collapses_ += static_cast<double>(report.collapses.done);
    flips_ += static_cast<double>(report.flips);
    if (watcher_ != nullptr) watcher_->improved(report);
  }

  Tracker tracker_;
  MeshSchedule schedule_;
  std::optional<SignedDistance> distance_;  ///< of the surface as it is, once it was asked for
  std::int64_t steps_ = 0;
  StepWatcher* watcher_ = nullptr;
  double gone_for_ = 0;                         ///< time since nothing was left
  bool remodelled_ = false, improved_ = false;  ///< since the last move
  double move_ = 0, remodel_ = 0, improve_ = 0;
  double remodels_ = 0, committed_ = 0, refused_ = 0, cells_ = 0;
  double subdivisions_ = 0, collapses_ = 0, flips_ = 0;
};

}  // namespace

std::unique_ptr<SurfaceTracker> make_mesh_tracker(Triangles surface, const TrackerOptions& options,
                                                  const MeshSchedule& schedule) {
  return std::make_unique<MeshTracker>(std::move(surface), options, schedule);
}

}  // namespace suture::sims
