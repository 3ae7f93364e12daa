// The interface of all that acts on the liquid beside gravity and pressure: one module an effect.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/liquid/liquid.h"
#include "sims/fluid/measure/fluid_step.h"
#include "sims/fluid/measure/module_cost.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// A step's velocity and what it is about. Lives for the step.
struct StepState {
  MacVelocity& velocity;
  FlowDomain domain;
  const Solids& solids;
  const Triangles& surface;
  double time = 0, dt = 0;
};

/// The terms that effects add to the projection, as in ProjectionInput. Empty arrays stand for
/// none.
struct ProjectionTerms {
  std::array<std::vector<double>, 3> jump;
  std::vector<double> divergence;

  void add_jump(std::array<std::vector<double>, 3> more);
  void add_divergence(std::vector<double> more);
};

/// Gives the place to which a point of the surface goes in a step.
using SurfacePath = std::function<Point(const Point&)>;

/// An effect that a scene names; one that it does not name is not made. A step calls the functions
/// in their order here, each for all effects in the order of effect_makers(). What an effect does
/// not need it leaves as it is here: nothing. Each counts its own costs.
class Effect {
 public:
  virtual ~Effect() = default;

  /// The longest step that what is explicit in the effect allows.
  virtual double longest_step() const { return std::numeric_limits<double>::infinity(); }
  /// Moves what the liquid carries onto the liquid's new grid, by the velocity on the one before
  /// and over the dt that the surface last moved by: what is carried lives at the surface's times.
  virtual void carry(const MacVelocity& /*old*/, const Liquid& /*liquid*/, double /*dt*/) {}
  /// Acts on the velocity itself, before the projection.
  virtual void stress(const StepState& /*step*/) {}
  /// Adds what the projection is to know of.
  virtual void project(const StepState& /*step*/, ProjectionTerms& /*terms*/) {}
  /// Hears of the velocity as it is after the projection, known wherever there is liquid, and of
  /// the dt that the surface is about to move by.
  virtual void flowed(const StepState& /*step*/) {}
  /// Writes what reports say of the effect's step.
  virtual void report(FluidStep& /*step*/) const {}
  /// The velocity of the surface itself at p near it, which is added to the flow's. Any number of
  /// threads may ask.
  virtual Point of_surface(const Point& /*p*/) const { return Point::Zero(); }
  /// These are called before and after the surface moves through a step. `path` gives where its
  /// points have gone.
  virtual void before_move(SurfaceTracker& /*surface*/) {}
  virtual void after_move(SurfaceTracker& /*surface*/, const SurfacePath& /*path*/) {}
  /// These are called before and after a change of triangles that moves nothing.
  virtual void before_remodel(const Triangles& /*surface*/) {}
  virtual void after_remodel(const Triangles& /*surface*/) {}
};

}  // namespace suture::sims
