// What a scene names beyond an inviscid liquid, each made only where it does.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "sims/fluid/fluid_options.h"
#include "sims/fluid/measure/module_cost.h"
#include "sims/fluid/velocity/pressure.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// A step's velocity and what it is about. Lives for the step.
struct StepState {
  MacVelocity& velocity;
  const Liquid& liquid;
  const SolidFaces& faces;
  const Solids& solids;
  const Triangles& surface;
  double time = 0, dt = 0;
};

/// The effects of a scene; those that it does not name are null, and have no arrays.
class Effects {
 public:
  /// \throw InvalidInput as the effects do for their options
  Effects(const FluidOptions& options, ModuleCosts& costs);
  ~Effects();

  /// The longest step that what is explicit allows; infinite where all is implicit.
  double longest_step() const;

  /// Moves what the liquid carries onto the liquid's grid, by the velocity on the one before.
  /// Strain lives at the surface's times, not at the velocity's: dt is what the surface last moved
  /// by.
  void carry(const MacVelocity& old, const Liquid& liquid, double dt);
  /// Told of the velocity as it is after the projection, known wherever there is liquid, and of the
  /// dt that the surface is about to move by.
  void flowed(const StepState& step);

  /// Viscosity and elasticity, on the velocity itself. Before the projection.
  void stress(const StepState& step);

  /// What the projection is to know of: the jump of surface tension, the divergence that brings
  /// volume back. Null where there is none; holds until the next call.
  const std::array<std::vector<double>, 3>* jump(const StepState& step);
  const std::vector<double>* divergence(const StepState& step);
  /// What of the surface tension the last jump has, less than 1 where dt was too long for it.
  double tension_share() const;

  /// What the surface does of itself at p near it, beside what flows there.
  Point of_surface(const Point& p) const;

  /// Moves the surface by `advect`, whose paths `move` gives, and tells whoever follows volumes.
  void moving(SurfaceTracker& surface, const std::function<void()>& advect,
              const std::function<Point(const Point&)>& move);
  /// Round what changes triangles but moves nothing.
  void before_remodel(const Triangles& surface);
  void after_remodel(const Triangles& surface);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace suture::sims
