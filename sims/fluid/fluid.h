// The fluid: velocity on a sparse staggered grid, a client of any surface tracker [§7].
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sims/fluid/fluid_options.h"
#include "sims/fluid/liquid_measures.h"
#include "sims/rivals/surface_tracker.h"

namespace suture {

/// What one effect has taken so far. What a scene does not name is not in the list.
struct ModuleCost {
  std::string name;
  double seconds = 0;       ///< CPU of this process
  std::size_t bytes = 0;    ///< of its arrays, the most at any step
  std::int64_t solves = 0;  ///< linear systems
  std::int64_t iterations = 0;
};

/// The last step, for reports.
struct FluidStep {
  double dt = 0;
  double cfl = 0;              ///< cells that the fastest liquid crossed
  std::size_t cells = 0;       ///< of the grid
  std::size_t liquid = 0;      ///< of these
  double pressure_residual = 0;
  double largest_divergence = 0;  ///< times dt; the wanted divergence taken off
};

/// Incompressible liquid under a free surface [Bridson 2015]. The surface is whoever's tracks it;
/// the velocity lives half a step behind it, so that free fall is exact and both are second order
/// in a smooth force.
class Fluid {
 public:
  using Initial = std::function<Point(const Point&)>;  ///< velocity at a place, at time 0

  /// \throw InvalidInput for options out of range, or that cannot work together
  Fluid(FluidOptions options, Initial initial);
  ~Fluid();

  /// The longest step that the CFL number and the explicit effects allow now, at most `left`; cuts
  /// `left` into equal steps. \pre left > 0
  double step_towards(double left) const;

  /// Brings the velocity forward to the middle of the next step, and moves the surface by dt.
  /// \throw InvalidInput if a velocity is beyond the finite numbers, as SurfaceTracker::advect
  void step(SurfaceTracker& surface, double dt);

  /// For volume control, which is not to undo what topology does: the surface about to be remodelled,
  /// and as it came out. Do nothing without it.
  void before_remodel(const Triangles& surface);
  void after_remodel(const Triangles& surface);

  /// At p now; near the liquid, elsewhere what the nearest liquid goes on with, or nothing.
  Point velocity(const Point& p) const;
  double time() const;
  const FluidStep& last() const;
  LiquidMeasures measures() const;  ///< of the last step
  std::vector<ModuleCost> costs() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace suture
