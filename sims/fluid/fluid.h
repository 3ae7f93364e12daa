// The fluid: velocity on a sparse staggered grid, a client of any surface tracker [§7].
//
// The rooms of sims/fluid, from the ground up; each includes only rooms before it, and the kernel:
//   grid/      cells and staggered arrays; a closed surface sampled on them
//   linear/    linear systems over grids, and how they are solved
//   solids/    walls and bodies, what they leave open of faces, the projection along them
//   liquid/    which cells are liquid: volume fractions, bodies, droplets, tracked components
//   velocity/  what every liquid's velocity goes through: advection and the pressure projection
//   measure/   what is told of a step: energies, costs by module
//   effects/   one module an effect; its numerics in stress/ and tension/ include no effect
//   (root)     the options, which effects a scene names, the order of a step, frames
// Of other rooms of sims, measure/ sees support/, and effects/ and the root see tracking/.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sims/fluid/fluid_options.h"
#include "sims/fluid/measure/fluid_step.h"
#include "sims/fluid/measure/liquid_measures.h"
#include "sims/fluid/measure/module_cost.h"
#include "sims/tracking/simulator.h"

namespace suture::sims {

/// Incompressible liquid under a free surface [Bridson 2015]. The surface is whoever's tracks it;
/// the velocity lives half a step behind it, so that free fall is exact and both are second order
/// in a smooth force.
class Fluid : public Simulator {
 public:
  using Initial = std::function<Point(const Point&)>;  ///< velocity at a place, at time 0

  /// \throw InvalidInput for options out of range, or that cannot work together
  Fluid(FluidOptions options, Initial initial);
  ~Fluid() override;

  /// The longest step that the CFL number and the effects that are explicit allow.
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

  /// The velocity at p now, in the liquid and some cells round it; elsewhere 0.
  Point velocity(const Point& p) const;
  double time() const;
  /// The liquid and its velocity as the last step's projection left them, half a step ago.
  LiquidMeasures measures() const;
  const FluidStep& last() const;  ///< the last step
  /// The costs by module, in the order in which they act; one that the scene does not name is not
  /// there.
  std::vector<ModuleCost> costs() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace suture::sims
