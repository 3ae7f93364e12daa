// The equations of an implicit viscous step: masses, and stresses between faces.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sims/fluid/effects/strain_rate.h"
#include "sims/fluid/linear/linear_solver.h"

namespace suture::sims {

/// One of the two cells at the face is liquid, so that a projection gives it a velocity.
inline bool touches(const Liquid& liquid, int axis, Slot face) {
  const Slot low = liquid.grid->neighbour(face, axis, -1);
  return liquid.inside(face) || (low != kNoSlot && liquid.inside(low));
}

/// What a viscous stress does in a step, in velocities: shares, h and density are divided out.
struct StressStep {
  /// dt·(dynamic viscosity)/(density·h²): what the stress does to a face's velocity per velocity.
  double stiffness = 0;
  /// Added to h times the strain rate before that is multiplied by the viscosity: an elastic
  /// stress.
  const TensorField* offset = nullptr;
  /// Multiplies the stress of each component. Null: 1.
  const TensorField* factor = nullptr;
  /// Faces that touch no cell of it have no mass: no projection gives them a velocity, what is
  /// extrapolated to them means nothing, and as it was they may take what makes the stress least.
  const Liquid* projected = nullptr;
};

/// The faces' velocities v that make ½Σ mass·(v − before)² + ½Σ stiffness·(way·v + constant)² over
/// the terms least: the variational form of the step [Batty and Bridson 2008, eq. 9].
struct ViscousSystem {
  struct Term {
    std::array<std::uint32_t, 4> unknown{kNone, kNone, kNone, kNone};
    std::array<float, 4> way{};
    double constant = 0, stiffness = 0;
    bool wall = false;  ///< it has a face that is not solved for

    double of(const std::vector<double>& v) const {
      double sum = 0;
      for (int n = 0; n < 4; ++n)
        if (unknown[n] != kNone) sum += way[n] * v[unknown[n]];
      return sum;
    }
  };
  struct Face {
    Slot slot;
    int axis;
  };
  const SparseGrid* grid = nullptr;
  std::vector<Face> faces;  ///< of the unknowns
  std::vector<double> mass, before;
  std::vector<Term> terms;
  Point wall_velocity = Point::Zero();  ///< mean over the terms' other faces

  std::size_t memory() const;
};

/// \throw InvalidInput if a velocity that counts is not finite
ViscousSystem viscous_system(const MacVelocity& velocity, const StrainRate& rate,
                             const StressStep& step, bool only_massless = false);

/// What a viscous step did: the solve, and the bytes it held at once beside its input.
struct DiffusionReport : SolveReport {
  std::size_t memory = 0;
};

/// Rows are divided by the square root of the diagonal, so that small shares weigh as whole ones,
/// and the residual is a part of what it would be at rest, or moving with the walls. The rigid
/// motion of each connected body, which no stress changes, is taken out and solved for by itself:
/// otherwise it would drown in rounding where stresses are 1e10 times the masses.
DiffusionReport solve(const ViscousSystem& system, std::vector<double>& v,
                      const SolverOptions& options);

/// Gives the known faces of the system the solution, and held ones of its terms, which become
/// known, the solids' velocity. Faces that are not known have no mass and stay so.
DiffusionReport step_stress(MacVelocity& velocity, const StrainRate& rate, const StressStep& step,
                            const SolverOptions& options);

/// Gives the faces without mass alone what makes the stress least, as step_stress does: what is
/// extrapolated to them would strain.
void relax_massless(MacVelocity& velocity, const StrainRate& rate, const StressStep& step);

}  // namespace suture::sims
