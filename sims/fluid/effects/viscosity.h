// Viscosity of the liquid, from none to that of a rigid body.
#pragma once

#include <memory>

#include "sims/fluid/effects/effect.h"
#include "sims/fluid/effects/stress/stress_step.h"

namespace suture::sims {

struct ViscosityOptions {
  double viscosity = 0;  ///< dynamic: force per area and per rate of shear (Pa·s in SI units)
  double density = 1;
  bool no_slip = true;  ///< at solids; else they only push, which is the projection's part

  WallSlip slip() const { return no_slip ? WallSlip::none : WallSlip::free; }
};

/// How far an implicit step goes, and how exactly it is solved for.
struct ImplicitStep {
  double dt = 0;
  SolverOptions solver{};
};

/// Diffuses the velocity over dt, implicitly, by the whole stress 2μD, zero at the free surface:
/// what turns as a rigid body is left alone, and columns buckle [Batty and Bridson 2008]. Kinetic
/// energy never grows, and a free body keeps its momenta to rounding. The velocity's error, as a
/// mean over the liquid's mass, is about the solver's tolerance of the velocity before. Beyond
/// kStiffest the step is that of kStiffest. \pre faces that have liquid are known
/// \throw InvalidInput for numbers that are not finite, viscosity or dt < 0, density ≤ 0
DiffusionReport diffuse(MacVelocity& velocity, const FlowDomain& domain,
                        const ViscosityOptions& viscosity, const ImplicitStep& step);

/// The most of dt·viscosity/(density·h²). What still deforms there is below 1e-12 (L/h)² of what
/// was, for a body of size L; a stiffer system would only lose the masses in rounding.
inline constexpr double kStiffest = 1e12;

/// \pre the options are in the ranges of their tables
std::unique_ptr<Effect> make_viscosity(const ViscosityOptions& options, const SolverOptions& solver,
                                       const ModuleAccount& account);

}  // namespace suture::sims
