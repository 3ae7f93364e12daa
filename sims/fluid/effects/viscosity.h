// Viscosity of the liquid, from none to that of a rigid body.
#pragma once

#include "sims/fluid/effects/stress/viscous_system.h"

namespace suture::sims {

struct ViscosityOptions {
  double viscosity = 0;  ///< dynamic: force per area and per rate of shear (Pa·s in SI units)
  double density = 1;
  bool no_slip = true;  ///< at solids; else they only push, which is the projection's part
};

/// Diffuses the velocity over dt, implicitly, by the whole stress 2μD, zero at the free surface:
/// what turns as a rigid body is left alone, and columns buckle [Batty and Bridson 2008]. Kinetic
/// energy never grows, and a free body keeps its momenta to rounding. The velocity's error, as a
/// mean over the liquid's mass, is about options.tolerance of the velocity before. Beyond
/// kStiffest the liquid is as good as rigid, and the step is that of kStiffest. Costs nothing where
/// viscosity or dt is 0. \pre faces that have liquid are known
/// \throw InvalidInput for numbers that are not finite, viscosity or dt < 0, density ≤ 0
DiffusionReport diffuse(MacVelocity& velocity, const Liquid& liquid, const SolidFaces& solids,
                        const ViscosityOptions& viscosity, double dt,
                        const SolverOptions& options = {});

/// Of dt·viscosity/(density·h²): what still deforms is below 1e-12 (L/h)² of what was, for a body
/// of size L; a stiffer system would only lose the masses in rounding.
inline constexpr double kStiffest = 1e12;

}  // namespace suture::sims
