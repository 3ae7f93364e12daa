// The mesh tracker behind the interface that the baselines have too.
#include "sims/tracking/mesh_tracker.h"

#include <optional>
#include <string>

#include "kernel/errors.h"
#include "kernel/measure/signed_distance.h"
#include "sims/support/clock.h"

namespace suture::sims {
namespace {

/// Counts its calls and their time. Where nothing is left, moves let the time pass and no more.
class MeshTracker : public SurfaceTracker {
 public:
  MeshTracker(Triangles surface, const TrackerOptions& options)
      : tracker_(std::move(surface), options) {}

  bool keeps_triangles() const override { return true; }

  void advect(const VelocityField& u, double dt) override {
    if (!vanished()) {
      distance_.reset();
      costs_.timed("move", [&] { tracker_.advect(u, dt); });
    }
    time_ += dt;
  }

  void displace(std::vector<Point> positions, double dt) override {
    if (!vanished()) {
      distance_.reset();
      costs_.timed("move", [&] { tracker_.displace(std::move(positions), dt); });
    } else if (!positions.empty()) {
      throw InvalidInput("displace was given positions for a surface of which nothing is left");
    }
    time_ += dt;
  }

  SurgeryReport remodel() override {
    require_surface("remodelled");
    distance_.reset();
    SurgeryReport report = costs_.timed("remodel", [&] { return tracker_.remodel(); });
    costs_.count("remodels");
    if (report.outcome == Outcome::refused) costs_.count("surgeries_refused");
    if (report.outcome != Outcome::committed) return report;
    costs_.count("surgeries_committed");
    costs_.count("cells_resampled", static_cast<double>(report.marked.total()));
    return report;
  }

  QualityReport improve() override {
    require_surface("improved");
    distance_.reset();
    QualityReport report = costs_.timed("improve", [&] { return tracker_.improve(); });
    costs_.count("subdivisions", static_cast<double>(report.subdivisions));
    costs_.count("collapses", static_cast<double>(report.collapses.done));
    costs_.count("flips", static_cast<double>(report.flips));
    return report;
  }

  void end_of_frame() override {}

  const Triangles& surface() override { return tracker_.surface(); }

  double distance(const Point& p) override {
    if (!distance_) distance_.emplace(tracker_.surface());
    return distance_->at(p);
  }

  double time() const override { return time_; }

  TrackerCost cost() const override { return costs_; }

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

std::unique_ptr<SurfaceTracker> make_mesh_tracker(Triangles surface,
                                                  const TrackerOptions& options) {
  return std::make_unique<MeshTracker>(std::move(surface), options);
}

}  // namespace suture::sims
