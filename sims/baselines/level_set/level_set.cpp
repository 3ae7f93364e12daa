// The level set as OpenVDB keeps it: distances in a narrow band, moved by upwind or MacCormack
// steps.
#include "sims/baselines/level_set/level_set.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "kernel/errors.h"
#include "sims/baselines/grid/level_set_grid.h"
#include "sims/baselines/level_set/mac_cormack.h"
#include "sims/baselines/level_set/upwind_advection.h"
#include "sims/support/clock.h"

namespace suture::sims {
namespace {

void require_order(int order, int least, int most, const char* name) {
  if (order < least || order > most)
    throw InvalidInput(std::string("the level set's ") + name + " is " + std::to_string(order) +
                       "; it must be " + std::to_string(least) + " to " + std::to_string(most));
}

class LevelSet : public SurfaceTracker {
 public:
  LevelSet(const Triangles& surface, const LevelSetOptions& o)
      : options_(o), band_{o.cell_size, o.origin, o.half_width} {
    require_order(o.time_order, 1, 3, "time_order");
    require_order(o.trace_order, 2, 4, "trace_order");
    require_order(o.renormalise.time_order, 1, 3, "renormalisation's time_order");
    require_order(o.renormalise.steps, 1, 1000, "renormalisation's steps");
    if (o.renormalise.every < 0)
      throw InvalidInput("a level set is re-normalised every 0 (never) or more steps");
    costs_.timed("begin", [&] { grid_ = make_level_set(surface, band_); });
  }

  void advect(const VelocityField& u, double dt) override {
    contour_.reset();
    costs_.timed("move", [&] {
      const GridVelocity velocity{u, band_.origin, band_.cell_size};
      if (options_.advection == Advection::upwind)
        upwind(velocity, dt);
      else
        mac_cormack_step(velocity, dt);
      time_ += dt;
      require_within_reach(*grid_);
    });
  }

  void end_of_frame() override {
    if (options_.renormalise.every == 0 || since_ == 0) return;
    contour_.reset();
    costs_.timed("move", [&] { relax(); });
  }

  const Triangles& surface() override {
    if (!contour_) costs_.timed("contour", [&] { contour_ = contour(*grid_, band_); });
    return *contour_;
  }

  double distance(const Point& p) override {
    auto values = grid_->getConstAccessor();
    return band_.cell_size * sampled(values, band_.index(p));
  }

  double time() const override { return time_; }

  TrackerCost cost() const override {
    return {costs_.seconds,
            {{"substeps", substeps_},
             {"renormalisations", renormalisations_},
             {"active_nodes", static_cast<double>(grid_->activeVoxelCount())}}};
  }

 private:
  /// Counts this sub-step; \return whether it ends with a re-normalisation.
  bool due() {
    const int every = options_.renormalise.every;
    if (every == 0) return false;
    since_ = (since_ + 1) % every;
    renormalisations_ += since_ == 0;
    return since_ == 0;
  }

  void relax() {
    renormalise(*grid_, options_.renormalise);
    since_ = 0;
    ++renormalisations_;
  }

  /// Sub-steps a little shorter than the library's own, so that each is one of these.
  void upwind(const GridVelocity& u, double dt) {
    constexpr double kSafety = 0.9;  // every eighth node is asked, and only at the start
    const double end = time_ + dt;
    for (double now = time_; now < end;) {
      const double speed = fastest(*grid_, u, now);
      const double longest = kSafety * courant_number(options_.time_order) / speed;
      const double left = end - now;
      const double parts = longest < left ? std::ceil(left / longest) : 1;
      if (!(parts < kMostSubsteps))
        throw InvalidInput("the velocity is not finite, or the step takes more than " +
                           std::to_string(kMostSubsteps) + " sub-steps; take shorter steps");
      advect_upwind(*grid_, u, {now, left / parts, due()}, options_);
      ++substeps_;
      now = parts > 1 ? now + left / parts : end;
    }
  }

  void mac_cormack_step(const GridVelocity& u, double dt) {
    grid_ = mac_cormack(*grid_, u, {{time_, dt, options_.trace_order}, options_.limiter});
    ++substeps_;
    if (due()) renormalise(*grid_, options_.renormalise);
  }

  static constexpr int kMostSubsteps = 1000000;

  LevelSetOptions options_;
  BandOptions band_;
  openvdb::FloatGrid::Ptr grid_;
  std::optional<Triangles> contour_;
  double time_ = 0;
  int since_ = 0;  ///< sub-steps since φ was a distance
  Costs costs_{{{"begin", 0}, {"move", 0}, {"contour", 0}}, {}};
  double substeps_ = 0, renormalisations_ = 0;
};

}  // namespace

std::unique_ptr<SurfaceTracker> make_level_set_tracker(const Triangles& surface,
                                                       const LevelSetOptions& options) {
  return std::make_unique<LevelSet>(surface, options);
}

}  // namespace suture::sims
