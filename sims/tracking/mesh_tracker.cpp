// The mesh tracker behind the interface that the baselines have too.
#include "sims/tracking/mesh_tracker.h"

#include <optional>
#include <string>

#include "kernel/errors.h"
#include "kernel/measure/signed_distance.h"
#include "sims/support/processes.h"

namespace suture::sims {
namespace {

/// Adds the CPU seconds of its life to a sum.
class Timer {
 public:
  explicit Timer(double& sum) : sum_(sum), start_(process_seconds()) {}
  ~Timer() { sum_ += process_seconds() - start_; }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  double& sum_;
  double start_;
};

/// Counts its calls and their time. Where nothing is left, moves let the time pass and no more.
class MeshTracker : public SurfaceTracker {
 public:
  MeshTracker(Triangles surface, const TrackerOptions& options)
      : tracker_(std::move(surface), options) {}

  bool keeps_triangles() const override { return true; }

  void advect(const VelocityField& u, double dt) override {
    if (!vanished()) {
      const Timer timer(move_);
      distance_.reset();
      tracker_.advect(u, dt);
    }
    time_ += dt;
  }

  void displace(std::vector<Point> positions, double dt) override {
    if (!vanished()) {
      const Timer timer(move_);
      distance_.reset();
      tracker_.displace(std::move(positions), dt);
    } else if (!positions.empty()) {
      throw InvalidInput("displace was given positions for a surface of which nothing is left");
    }
    time_ += dt;
  }

  SurgeryReport remodel() override {
    require_surface("remodelled");
    const Timer timer(remodel_);
    distance_.reset();
    SurgeryReport report = tracker_.remodel();
    ++remodels_;
    committed_ += report.outcome == Outcome::committed;
    refused_ += report.outcome == Outcome::refused;
    if (report.outcome == Outcome::committed) cells_ += static_cast<double>(report.marked.total());
    return report;
  }

  QualityReport improve() override {
    require_surface("improved");
    const Timer timer(improve_);
    distance_.reset();
    QualityReport report = tracker_.improve();
    subdivisions_ += static_cast<double>(report.subdivisions);
    collapses_ += static_cast<double>(report.collapses.done);
    flips_ += static_cast<double>(report.flips);
    return report;
  }

  void end_of_frame() override {}

  const Triangles& surface() override { return tracker_.surface(); }

  double distance(const Point& p) override {
    if (!distance_) distance_.emplace(tracker_.surface());
    return distance_->at(p);
  }

  double time() const override { return time_; }

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
  bool vanished() const { return tracker_.surface().triangles.empty(); }

  void require_surface(const std::string& what) const {
    if (vanished())
      throw InvalidInput("a surface of which nothing is left cannot be " + what +
                         "; look first whether it has triangles");
  }

  Tracker tracker_;
  std::optional<SignedDistance> distance_;  ///< of the surface as it is, once it was asked for
  double time_ = 0;                         ///< goes on where nothing is left
  double move_ = 0, remodel_ = 0, improve_ = 0;
  double remodels_ = 0, committed_ = 0, refused_ = 0, cells_ = 0;
  double subdivisions_ = 0, collapses_ = 0, flips_ = 0;
};

}  // namespace

std::unique_ptr<SurfaceTracker> make_mesh_tracker(Triangles surface,
                                                  const TrackerOptions& options) {
  return std::make_unique<MeshTracker>(std::move(surface), options);
}

}  // namespace suture::sims
