// What the linear solver asks of HYPRE, whose types are seen in no header.
#pragma once

#include "sims/fluid/grid/cell_boxes.h"
#include "sims/fluid/linear/linear_solver.h"

namespace suture::sims {

/// Powers of two that bring a system near 1: else products of tiny or huge numbers leave the range
/// of doubles, as no scene's units should make them.
struct SystemScale {
  int matrix = 0, right = 0;
};

/// Each solves from x as it is, adds to `iterations`, and throws InternalFailure where HYPRE
/// reports an error other than that it did not converge. \pre there is a row

/// By PFMG on boxes that hold all active cells and no missing one.
void solve_boxes(const SevenPoint& matrix, const std::vector<CellBox>& boxes,
                 const std::vector<double>& right, std::vector<double>& x, const SystemScale& scale,
                 const SolverOptions& options, int& iterations);

enum class RowsMethod { kDiagonal, kAmg };
void solve_rows(const SparseRows& matrix, const std::vector<double>& right, std::vector<double>& x,
                const SystemScale& scale, const SolverOptions& options, RowsMethod method,
                int& iterations);

}  // namespace suture::sims
