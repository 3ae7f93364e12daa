// The interface of everything that moves a surface: a prescribed motion, the fluid, any solver.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// A simulator has to supply `step`; the rest has defaults. README.md in this folder says more.
class Simulator {
 public:
  virtual ~Simulator() = default;

  /// Moves the surface from surface.time() to surface.time() + dt: along a velocity field by
  /// advect, or to new positions by displace. \throw InvalidInput as these
  virtual void step(SurfaceTracker& surface, double dt) = 0;

  /// The longest next step in the scene's unit of time; infinite where any length will do.
  virtual double longest_step() const { return std::numeric_limits<double>::infinity(); }

  /// The most steps that a frame may be cut into, longest_step or not.
  virtual int most_steps() const { return 1000; }

  /// Whether the surface has moved so far that it should be remodelled before the frame ends.
  virtual bool wants_topology() const { return false; }

  /// Called before and after whatever changes the surface's triangles without moving the surface.
  virtual void before_remodel(SurfaceTracker& /*surface*/) {}
  virtual void after_remodel(SurfaceTracker& /*surface*/) {}

  /// Called in between, for each remodel and each improvement of a mesh, with the surface as it is
  /// now. `vertex_map` has the new index of each old vertex, or kNone; empty: as it was.
  virtual void surface_changed(const Triangles& /*surface*/,
                               const std::vector<std::uint32_t>& /*vertex_map*/) {}

  /// How many equal steps take the surface through `left`, from 1 to most_steps(). \pre left > 0
  int steps_in(double left) const;
};

}  // namespace suture::sims
