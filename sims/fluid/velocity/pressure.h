// Makes the velocity of the liquid free of divergence, or of the divergence that is wanted.
#pragma once

#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/linear/linear_solver.h"
#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {

struct ProjectionInput {
  const Liquid& liquid;
  const SolidFaces& solids;
  double density = 1, dt = 1;
  /// A value a face: pressure in the liquid minus that of the air where the surface crosses between
  /// the cells at it; surface tension. Null: none.
  const std::array<std::vector<double>, 3>* jump = nullptr;
  /// The divergence that is wanted in each cell, per unit of time. Null: none.
  const std::vector<double>* divergence = nullptr;
};

/// The variational cut-cell projection [Batty et al. 2007], the surface where it is between cell
/// centres [Gibou et al. 2002; Enright et al. 2003]. Afterwards the faces that are open and touch
/// liquid are known, and those of droplets without a cell as before; no others. Closed faces of
/// liquid cells hold the solid's velocity, but constrain (wall_projection.h) needs them unknown.
/// Liquid that no air touches cannot change its volume: there the mean of the wanted divergence
/// and of what solids press in is left out.
/// \pre faces that touch liquid and are open hold numbers, known or not
/// \throw InvalidInput if density or dt are not positive, sizes do not fit, or numbers not finite
SolveReport project(MacVelocity& velocity, const ProjectionInput& input,
                    const SolverOptions& options = {});

}  // namespace suture::sims
