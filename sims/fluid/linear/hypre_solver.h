// What the linear solver asks of HYPRE, whose types are seen in no header.
#pragma once

#include "sims/fluid/grid/cell_boxes.h"
#include "sims/fluid/linear/linear_system.h"

namespace suture::sims {

/// Powers of two that bring a system near 1: else products of tiny or huge numbers leave the range
/// of doubles, as no scene's units should make them.
struct SystemScale {
  int matrix = 0, right = 0;
};

/// A right side, and how the system is to be solved for it. Keeps a reference to the values.
struct HypreTask {
  const std::vector<double>& right;
  SystemScale scale;
  SolverOptions options;
};

/// Each solves from x as it is and returns how many iterations it took. x stays as it was where
/// what is found is not finite. \throw InternalFailure where HYPRE reports an error other than that
/// it did not converge. \pre there is a row

/// Uses PFMG on boxes that hold all active cells and no missing one.
int solve_boxes(const SevenPoint& matrix, const std::vector<CellBox>& boxes, const HypreTask& task,
                std::vector<double>& x);

enum class RowsMethod { kDiagonal, kAmg };
int solve_rows(const SparseRows& matrix, RowsMethod method, const HypreTask& task,
               std::vector<double>& x);

}  // namespace suture::sims
