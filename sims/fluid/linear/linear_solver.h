// Symmetric positive definite systems of the fluid, by conjugate gradients of HYPRE.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sims/fluid/grid/sparse_grid.h"

namespace suture::sims {

struct SolverOptions {
  double tolerance = 1e-6;  ///< of the residual, as a part of the right side's size (2-norms)
  int most_iterations = 500;
};

/// What a solve did. It converged where `residual` is the tolerance asked for or less; a tenth more
/// is rounding.
struct SolveReport {
  int iterations = 0;
  double residual = 0;  ///< measured at the end, as the tolerance; 0 where the right side is 0
};

/// One row a cell, which meets its six neighbours: row s of the product is diagonal[s]·x[s] and,
/// for each axis, low[axis][s] times x of the neighbour below, and low[axis] of the neighbour
/// above times its x. \pre where low is not 0, both cells are active
struct SevenPoint {
  const SparseGrid* grid = nullptr;
  std::vector<double> diagonal;            ///< > 0 in active rows
  std::array<std::vector<double>, 3> low;  ///< ≤ 0: the coupling with the neighbour below
  std::vector<std::uint8_t> active;        ///< the rows that are unknowns

  SevenPoint() = default;
  explicit SevenPoint(const SparseGrid& g) : grid(&g), diagonal(g.size(), 0), active(g.size(), 0) {
    for (auto& l : low) l.assign(g.size(), 0);
  }
};

/// Compressed rows: row r has the entries first[r] to first[r+1] − 1. Columns of a row in any
/// order, each once, the diagonal among them. \pre symmetric and positive definite
struct SparseRows {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> column;
  std::vector<double> value;
  /// Where the unknowns are a vector field's, which component each row is, 0 to 2: AMG then
  /// coarsens each by itself, without which it meets the strain of liquids badly. Empty: they are a
  /// scalar's.
  std::vector<std::uint8_t> component;

  std::size_t rows() const { return first.empty() ? 0 : first.size() - 1; }
};

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
