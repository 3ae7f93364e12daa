// Checks and scales systems, and chooses how HYPRE is to solve them.
#include "sims/fluid/linear/linear_solver.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/errors.h"
#include "sims/fluid/grid/cell_boxes.h"
#include "sims/fluid/linear/hypre_solver.h"

namespace suture::sims {
namespace {

// Measured with pools, waves and drops of 65,000 to 416,000 unknowns: PFMG takes some 0.5 µs a cell
// of its boxes, and beyond some two hundred boxes a time that grows with their square; AMG takes
// 2 µs a row wherever the rows are.
constexpr std::size_t kMostBoxes = 250;
constexpr std::size_t kCellsPerRow = 4;

/// So many iterations with diagonal scaling cost what AMG does in all, for matrices of diffusion.
constexpr int kDiagonalIterations = 140;
/// It is seen after so many whether they will do.
constexpr int kTrial = 40;

/// The residual that conjugate gradients carry along may say less than the true one, by rounding.
constexpr double kDrift = 1.1;

void require_size(std::size_t size, std::size_t rows, const char* what) {
  if (size != rows)
    throw InvalidInput(std::string("linear solver: ") + what +
                       " has not one value a row of the matrix; both must be of one grid");
}

/// A right side, and how large its numbers and those of the matrix's diagonal are.
struct RightSide {
  const std::vector<double>& values;
  double diagonal = 0, size = 0;

  void add(double d, std::size_t row) {
    const double b = values[row];
    if (!(d > 0) || !std::isfinite(d) || !std::isfinite(b))
      throw InvalidInput("linear solver: row " + std::to_string(row) + " has the diagonal " +
                         number(d) + " and the right side " + number(b) +
                         "; the first must be positive and both finite");
    diagonal = std::max(diagonal, d);
    size = std::max(size, std::abs(b));
  }
  HypreTask task(const SolverOptions& options) const {
    return {values, {std::ilogb(diagonal), std::ilogb(size)}, options};
  }
};

/// The relative residual, from sums that neither vanish nor overflow at any scale.
class Residual {
 public:
  explicit Residual(const RightSide& right) : unit_(right.size) {}
  void add(double b, double ax) {
    right_ += (b / unit_) * (b / unit_);
    rest_ += ((b - ax) / unit_) * ((b - ax) / unit_);
  }
  double relative() const { return std::sqrt(rest_ / right_); }

 private:
  double unit_, right_ = 0, rest_ = 0;
};

double residual(const SevenPoint& m, const RightSide& right, const std::vector<double>& x) {
  Residual sum(right);
  for (Slot s = 0; s < x.size(); ++s) {
    if (m.active[s] == 0) continue;
    double ax = m.diagonal[s] * x[s];
    for (int a = 0; a < 3; ++a) {
      if (m.low[a][s] != 0) ax += m.low[a][s] * x[m.grid->neighbour(s, a, -1)];
      const Slot above = m.grid->neighbour(s, a, 1);
      if (above != kNoSlot && m.low[a][above] != 0) ax += m.low[a][above] * x[above];
    }
    sum.add(right.values[s], ax);
  }
  return sum.relative();
}

double residual(const SparseRows& m, const RightSide& right, const std::vector<double>& x) {
  Residual sum(right);
  for (std::size_t r = 0; r < m.rows(); ++r) {
    double ax = 0;
    for (std::size_t n = m.first[r]; n < m.first[r + 1]; ++n) ax += m.value[n] * x[m.column[n]];
    sum.add(right.values[r], ax);
  }
  return sum.relative();
}

bool reached(const SolveReport& report, const SolverOptions& options) {
  return report.residual <= kDrift * options.tolerance;
}

SolveStatus status_of(const SolveReport& report, const SolverOptions& options) {
  return reached(report, options)                      ? SolveStatus::converged
         : report.iterations < options.most_iterations ? SolveStatus::broken_down
                                                       : SolveStatus::iterations_exhausted;
}

/// The active rows alone.
struct ActiveRows {
  SparseRows rows;
  std::vector<Slot> slots;
};

ActiveRows active_rows(const SevenPoint& m) {
  ActiveRows made;
  std::vector<std::uint32_t> number_of(m.active.size(), kNone);
  for (Slot s = 0; s < m.active.size(); ++s)
    if (m.active[s] != 0) {
      number_of[s] = static_cast<std::uint32_t>(made.slots.size());
      made.slots.push_back(s);
    }
  SparseRows& rows = made.rows;
  rows.first.push_back(0);
  const auto add = [&](Slot s, double value) {
    rows.column.push_back(number_of[s]);
    rows.value.push_back(value);
  };
  for (const Slot s : made.slots) {
    add(s, m.diagonal[s]);
    for (int a = 0; a < 3; ++a) {
      if (m.low[a][s] != 0) add(m.grid->neighbour(s, a, -1), m.low[a][s]);
      const Slot above = m.grid->neighbour(s, a, 1);
      if (above != kNoSlot && m.low[a][above] != 0) add(above, m.low[a][above]);
    }
    rows.first.push_back(rows.column.size());
  }
  return made;
}

/// Solves by AMG on the active rows alone, and returns the iterations.
int solve_by_rows(const SevenPoint& m, const HypreTask& task, std::vector<double>& x) {
  const ActiveRows active = active_rows(m);
  std::vector<double> b, y;
  for (const Slot s : active.slots) {
    b.push_back(task.right[s]);
    y.push_back(x[s]);
  }
  const int done = solve_rows(active.rows, RowsMethod::kAmg, {b, task.scale, task.options}, y);
  for (std::size_t n = 0; n < y.size(); ++n) x[active.slots[n]] = y[n];
  return done;
}

bool worth_boxes(const std::vector<CellBox>& boxes, std::size_t rows) {
  std::size_t cells = 0;
  for (const CellBox& box : boxes) cells += box.cells();
  return boxes.size() <= kMostBoxes && cells <= kCellsPerRow * rows;
}

void require_finite(const std::vector<double>& x) {
  for (const double v : x)
    if (!std::isfinite(v))
      throw InvalidInput("linear solver: the first guess is not finite; start from zeros");
}

SolverOptions with_iterations(const SolverOptions& options, int most) {
  SolverOptions rest = options;
  rest.most_iterations = most;
  return rest;
}

/// \throw InvalidInput if an array is not of the matrix's grid
void check_sizes(const SevenPoint& matrix, const std::vector<double>& right) {
  const std::size_t size = matrix.grid == nullptr ? 0 : matrix.grid->size();
  require_size(matrix.diagonal.size(), size, "the matrix");
  require_size(matrix.active.size(), size, "the matrix");
  for (const auto& low : matrix.low) require_size(low.size(), size, "the matrix");
  require_size(right.size(), size, "the right side");
}

}  // namespace

SolveReport solve(const SevenPoint& matrix, const std::vector<double>& right,
                  std::vector<double>& x, const SolverOptions& options) {
  check_sizes(matrix, right);
  const std::size_t size = right.size();
  if (x.size() != size) x.assign(size, 0);
  RightSide side{right};
  std::size_t rows = 0;
  for (Slot s = 0; s < size; ++s) {
    if (matrix.active[s] == 0) {
      x[s] = 0;
      continue;
    }
    side.add(matrix.diagonal[s], s);
    ++rows;
  }
  require_finite(x);
  SolveReport report;
  if (side.size == 0) {
    x.assign(size, 0);
    return report;
  }
  report.residual = residual(matrix, side, x);
  if (report.residual <= options.tolerance) return report;  // HYPRE would take an iteration
  const std::vector<CellBox> boxes = active_boxes(*matrix.grid, matrix.active);
  if (worth_boxes(boxes, rows)) {
    report.iterations = solve_boxes(matrix, boxes, side.task(options), x);
    report.residual = residual(matrix, side, x);
  }
  if (const int left = options.most_iterations - report.iterations;
      !reached(report, options) && left > 0) {
    report.iterations += solve_by_rows(matrix, side.task(with_iterations(options, left)), x);
    report.residual = residual(matrix, side, x);
  }
  report.status = status_of(report, options);
  return report;
}

SolveReport solve(const SparseRows& matrix, const std::vector<double>& right,
                  std::vector<double>& x, const SolverOptions& options) {
  const std::size_t rows = matrix.rows();
  require_size(right.size(), rows, "the right side");
  if (!matrix.component.empty()) require_size(matrix.component.size(), rows, "the component");
  if (x.size() != rows) x.assign(rows, 0);
  require_finite(x);
  RightSide side{right};
  for (std::size_t r = 0; r < rows; ++r) {
    double diagonal = 0;
    for (std::size_t n = matrix.first[r]; n < matrix.first[r + 1]; ++n)
      if (matrix.column[n] == r) diagonal = matrix.value[n];
    side.add(diagonal, r);
  }
  SolveReport report;
  if (side.size == 0) {
    x.assign(rows, 0);
    return report;
  }
  report.residual = residual(matrix, side, x);
  if (report.residual <= options.tolerance) return report;
  const auto go_on = [&](RowsMethod method, int most) {
    most = std::min(most, options.most_iterations - report.iterations);
    if (reached(report, options) || most <= 0) return;
    report.iterations += solve_rows(matrix, method, side.task(with_iterations(options, most)), x);
    report.residual = residual(matrix, side, x);
  };
  go_on(RowsMethod::kDiagonal, kTrial);
  const double needed = kTrial * std::log(options.tolerance) / std::log(report.residual);
  if (report.residual < 1 && needed <= kDiagonalIterations)
    go_on(RowsMethod::kDiagonal, kDiagonalIterations - kTrial);
  go_on(RowsMethod::kAmg, options.most_iterations);
  report.status = status_of(report, options);
  return report;
}

}  // namespace suture::sims
