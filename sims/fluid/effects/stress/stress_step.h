// An implicit step of a viscous stress: the viscous system, solved, and the velocities it gives.
#pragma once

#include <vector>

#include "sims/fluid/effects/stress/viscous_system.h"

namespace suture::sims {

/// A viscous step's solve, and the bytes that it held at once beside its input.
struct [[nodiscard]] DiffusionReport : SolveReport {
  std::size_t memory = 0;
};

/// Rows are divided by the square root of the diagonal, so that small fractions weigh as whole
/// ones, and the residual is a part of what it would be at rest, or moving with the walls. The
/// rigid motion of each connected body, which no stress changes, is taken out and solved for by
/// itself: otherwise it would drown in rounding where stresses are 1e10 times the masses.
DiffusionReport solve(const ViscousSystem& system, std::vector<double>& v,
                      const SolverOptions& options);

/// Gives the known faces of the system the solution, and held ones of its terms, which become
/// known, the solids' velocity. Faces that are not known have no mass and stay so.
DiffusionReport step_stress(MacVelocity& velocity, const StrainRate& rate, const StressStep& step,
                            const SolverOptions& options);

/// Gives the faces without mass alone what makes the stress least, as step_stress does: what is
/// extrapolated to them would strain.
SolveReport relax_massless(MacVelocity& velocity, const StrainRate& rate, const StressStep& step);

}  // namespace suture::sims
