// Solves the fluid's linear systems by conjugate gradients of HYPRE.
#pragma once

#include "sims/fluid/linear/linear_system.h"

namespace suture::sims {

/// Solves matrix·x = right from x as it is, if it has the right size, else from 0; rows that are
/// not active give 0. One thread, and the same bits every time. Conjugate gradients, preconditioned
/// by HYPRE's PFMG multigrid [Falgout and Jones 2000]. \throw InvalidInput where sizes do not fit,
/// or a number of an active row is not finite
SolveReport solve(const SevenPoint& matrix, const std::vector<double>& right,
                  std::vector<double>& x, const SolverOptions& options = {});

/// The same for a matrix of any pattern.
SolveReport solve(const SparseRows& matrix, const std::vector<double>& right,
                  std::vector<double>& x, const SolverOptions& options = {});

}  // namespace suture::sims
