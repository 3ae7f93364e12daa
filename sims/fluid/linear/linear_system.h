// Symmetric positive definite systems of the fluid, and the report of a solve.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sims/fluid/grid/sparse_grid.h"

namespace suture::sims {

struct SolverOptions {
  double tolerance = 1e-6;  ///< of the residual, as a part of the right side's size (2-norms)
  int most_iterations = 500;
};

enum class SolveStatus {
  converged,             ///< the residual is the tolerance asked for or less; a tenth is rounding
  iterations_exhausted,  ///< it is not, after most_iterations
  broken_down            ///< it is not, and conjugate gradients found no way on before that
};

/// The report of a solve. One that did not converge leaves the last finite iterate: whoever goes on
/// with that has to say so (ModuleCosts::checked).
struct [[nodiscard]] SolveReport {
  int iterations = 0;
  double residual = 0;  ///< measured at the end, as the tolerance; 0 where the right side is 0
  SolveStatus status = SolveStatus::converged;

  bool converged() const { return status == SolveStatus::converged; }
};

/// One row a cell, which meets its six neighbours: row s of the product is diagonal[s]·x[s] and,
/// for each axis, low[axis][s] times x of the neighbour below, and low[axis] of the neighbour
/// above times its x. \pre where low is not 0, both cells are active
struct SevenPoint {
  SharedGrid grid;
  std::vector<double> diagonal;            ///< > 0 in active rows
  std::array<std::vector<double>, 3> low;  ///< ≤ 0: the coupling with the neighbour below
  std::vector<std::uint8_t> active;        ///< the rows that are unknowns

  SevenPoint() = default;
  /// \pre g is not null
  explicit SevenPoint(SharedGrid g)
      : grid(std::move(g)), diagonal(grid->size(), 0), active(grid->size(), 0) {
    for (auto& l : low) l.assign(grid->size(), 0);
  }
};

/// Compressed rows: row r has the entries first[r] to first[r+1] − 1. Columns of a row in any
/// order, each once, the diagonal among them. \pre symmetric and positive definite
struct SparseRows {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> column;
  std::vector<double> value;
  /// The component, 0 to 2, that each row is where the unknowns are a vector field's: AMG then
  /// coarsens each by itself, without which it meets the strain of liquids badly. Empty: they are a
  /// scalar's.
  std::vector<std::uint8_t> component;

  std::size_t rows() const { return first.empty() ? 0 : first.size() - 1; }
};

}  // namespace suture::sims
