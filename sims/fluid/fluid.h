// The fluid: velocity on a sparse staggered grid, a client of any surface tracker [§7].
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sims/fluid/fluid_options.h"
#include "sims/fluid/liquid/liquid_measures.h"
#include "sims/fluid/module_cost.h"
#include "sims/tracking/simulator.h"

namespace suture::sims {

/// The last step, for reports.
struct FluidStep {
  double dt = 0;
  double cfl = 0;          ///< cells that the fastest liquid crosses in dt
  std::size_t cells = 0;   ///< of the grid
  std::size_t liquid = 0;  ///< of these
  std::size_t drops = 0;   ///< bodies of liquid without a cell centre
  double residual = 0;     ///< of the projection, as SolveReport's
  /// What of the surface tension acts: less than 1 where the step is longer than its waves allow.
  double tension_share = 1;
};

/// Incompressible liquid under a free surface [Bridson 2015]. The surface is whoever's tracks it;
/// the velocity lives half a step behind it, so that free fall is exact and both are second order
/// in a smooth force.
class Fluid : public Simulator {
 public:
  using Initial = std::function<Point(const Point&)>;  ///< velocity at a place, at time 0

  /// \throw InvalidInput for options out of range, or that cannot work together
  Fluid(FluidOptions options, Initial initial);
  ~Fluid() override;

  /// As the CFL number and the effects that are explicit allow.
  double longest_step() const override;
  int most_steps() const override;

  /// Brings the velocity forward to the middle of the next dt, then moves the surface through it.
  /// \throw InvalidInput if a velocity is beyond the finite numbers, as SurfaceTracker::advect
  void step(SurfaceTracker& surface, double dt) override;

  /// Volume control hands on what each body of liquid should have.
  void before_remodel(SurfaceTracker& surface) override;
  void after_remodel(SurfaceTracker& surface) override;

  /// Whether the surface has moved so far since after_remodel that the next step might take it
  /// beyond FluidOptions::topology_cells: a surgery should come first.
  bool wants_topology() const override;

  /// At p now: in the liquid and some cells round it; elsewhere 0.
  Point velocity(const Point& p) const;
  double time() const;
  /// Of the liquid and its velocity as the last step's projection left them, half a step ago.
  LiquidMeasures measures() const;
  const FluidStep& last() const;
  /// In the order in which they act; what the scene does not name is not there.
  std::vector<ModuleCost> costs() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace suture::sims
