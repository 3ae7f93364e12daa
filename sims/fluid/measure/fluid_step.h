// A step of the fluid as reports tell of it.
#pragma once

#include <cstddef>

namespace suture::sims {

struct FluidStep {
  double dt = 0;
  double cfl = 0;          ///< cells that the fastest liquid crosses in dt
  std::size_t cells = 0;   ///< of the grid
  std::size_t liquid = 0;  ///< of these
  std::size_t drops = 0;   ///< bodies of liquid without a cell centre
  double residual = 0;     ///< of the projection, as SolveReport's
  /// The part of the surface tension that acts: less than 1 where the step is longer than its waves
  /// allow.
  double tension_share = 1;
  /// Linear solves that did not converge; the step went on with what they had.
  std::size_t unconverged = 0;
};

}  // namespace suture::sims
