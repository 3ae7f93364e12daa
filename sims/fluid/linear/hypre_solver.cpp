// Conjugate gradients of HYPRE; no other file meets it, or MPI, which it cannot do without.
#include "sims/fluid/linear/hypre_solver.h"

#define OMPI_SKIP_MPICXX  // bindings that MPI has given up, and that need a library more
#include <HYPRE.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <HYPRE_struct_ls.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

/// MPI from the first solve to the end of this process, as one process alone.
class MpiSession {
 public:
  MpiSession() {
    int running = 0;
    MPI_Initialized(&running);
    if (running == 0) {
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);  // else Open MPI starts a daemon
      MPI_Init(nullptr, nullptr);
      owner_ = getpid();
    }
    HYPRE_Init();
  }
  ~MpiSession() {
    int over = 0;
    MPI_Finalized(&over);
    if (over == 0 && owner_ == getpid()) MPI_Finalize();  // a forked child leaves it to its parent
  }
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

 private:
  pid_t owner_ = 0;
};

void need_mpi() { static const MpiSession session; }

/// A handle of HYPRE's, destroyed with its owner.
template <class Handle, auto destroy>
struct Destroy {
  void operator()(Handle handle) const { destroy(handle); }
};
template <class Handle, auto destroy>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Destroy<Handle, destroy>>;

using StructGrid = Owned<HYPRE_StructGrid, HYPRE_StructGridDestroy>;
using StructStencil = Owned<HYPRE_StructStencil, HYPRE_StructStencilDestroy>;
using StructMatrix = Owned<HYPRE_StructMatrix, HYPRE_StructMatrixDestroy>;
using StructVector = Owned<HYPRE_StructVector, HYPRE_StructVectorDestroy>;
using Pfmg = Owned<HYPRE_StructSolver, HYPRE_StructPFMGDestroy>;
using StructCg = Owned<HYPRE_StructSolver, HYPRE_StructPCGDestroy>;
using IjMatrix = Owned<HYPRE_IJMatrix, HYPRE_IJMatrixDestroy>;
using IjVector = Owned<HYPRE_IJVector, HYPRE_IJVectorDestroy>;
using Amg = Owned<HYPRE_Solver, HYPRE_BoomerAMGDestroy>;
using RowsCg = Owned<HYPRE_Solver, HYPRE_ParCSRPCGDestroy>;

/// Throws what HYPRE complains of, except that it did not converge, or that conjugate gradients
/// broke down on a cycle that is not positive: the residual tells either.
void check_hypre() {
  const HYPRE_Int error = HYPRE_GetError();
  HYPRE_ClearAllErrors();
  if ((error & ~(HYPRE_ERROR_CONV | HYPRE_ERROR_GENERIC)) != 0)
    throw InternalFailure("linear solver", "HYPRE's error " + std::to_string(error));
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// A preconditioner does one cycle, from 0.
constexpr double kNoTolerance = 0;

// Boxes of cells: HYPRE's structured interface, whose first axis is the fastest.

Index3 turned(const Index3& c) { return {c[2], c[1], c[0]}; }

/// Boxes of a sparse grid's cells, as HYPRE knows them.
class BoxGrid {
 public:
  BoxGrid(const SparseGrid& cells, const std::vector<CellBox>& boxes)
      : cells_(cells), boxes_(boxes) {
    HYPRE_StructGrid grid = nullptr;
    HYPRE_StructGridCreate(MPI_COMM_SELF, 3, &grid);
    for (const CellBox& box : boxes) {
      Index3 low = turned(box.low), high = turned(box.high);
      HYPRE_StructGridSetExtents(grid, low.data(), high.data());
    }
    HYPRE_StructGridAssemble(grid);
    grid_ = StructGrid(grid);
  }

  StructMatrix matrix(const SevenPoint& from, const SystemScale& scale) const;
  /// value(slot) in each cell of the boxes.
  template <class Value>
  StructVector vector(Value value) const;
  /// Calls visit(slot, number) with the vector's number of each cell.
  template <class Visit>
  void read(const StructVector& vector, Visit visit) const;

 private:
  template <class Visit>
  void visit_box(const CellBox& box, Visit visit) const;

  const SparseGrid& cells_;
  const std::vector<CellBox>& boxes_;
  StructGrid grid_;
};

/// Calls visit(slot, n) with the cells of a box, as HYPRE orders them.
template <class Visit>
void BoxGrid::visit_box(const CellBox& box, Visit visit) const {
  std::size_t n = 0;
  for (int x = box.low[0]; x <= box.high[0]; ++x)
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      Slot s = kNoSlot;
      for (int z = box.low[2]; z <= box.high[2]; ++z, ++n) {
        s = s == kNoSlot || z % SparseGrid::kSide == 0 ? cells_.find({x, y, z}) : s + 1;
        visit(s, n);
      }
    }
}

/// The cell itself, and those below it along x, y, z.
StructStencil lower_stencil() {
  HYPRE_StructStencil stencil = nullptr;
  HYPRE_StructStencilCreate(3, 4, &stencil);
  StructStencil made(stencil);
  for (int entry = 0; entry < 4; ++entry) {
    Index3 offset{};
    if (entry > 0) offset[3 - entry] = -1;
    HYPRE_StructStencilSetElement(stencil, entry, offset.data());
  }
  return made;
}

/// The mean of the active rows' diagonals, which other cells' rows are multiples of 1 by.
double mean_diagonal(const SevenPoint& m, const SystemScale& scale) {
  double sum = 0;
  std::size_t count = 0;
  for (Slot s = 0; s < m.active.size(); ++s)
    if (m.active[s] != 0) sum += std::ldexp(m.diagonal[s], -scale.matrix), ++count;
  return sum / static_cast<double>(count);
}

StructMatrix BoxGrid::matrix(const SevenPoint& from, const SystemScale& scale) const {
  const StructStencil stencil = lower_stencil();
  HYPRE_StructMatrix matrix = nullptr;
  HYPRE_StructMatrixCreate(MPI_COMM_SELF, grid_.get(), stencil.get(), &matrix);
  StructMatrix made(matrix);
  HYPRE_StructMatrixSetSymmetric(matrix, 1);
  HYPRE_StructMatrixInitialize(matrix);
  const double identity = mean_diagonal(from, scale);
  std::vector<double> values;
  for (const CellBox& box : boxes_) {
    values.assign(4 * box.cells(), 0);
    visit_box(box, [&](Slot s, std::size_t n) {
      const bool active = from.active[s] != 0;
      values[4 * n] = active ? std::ldexp(from.diagonal[s], -scale.matrix) : identity;
      for (int a = 0; active && a < 3; ++a)
        values[4 * n + 1 + a] = std::ldexp(from.low[a][s], -scale.matrix);
    });
    Index3 low = turned(box.low), high = turned(box.high);
    std::array<HYPRE_Int, 4> entries{0, 1, 2, 3};
    HYPRE_StructMatrixSetBoxValues(matrix, low.data(), high.data(), 4, entries.data(),
                                   values.data());
  }
  HYPRE_StructMatrixAssemble(matrix);
  return made;
}

template <class Value>
StructVector BoxGrid::vector(Value value) const {
  HYPRE_StructVector vector = nullptr;
  HYPRE_StructVectorCreate(MPI_COMM_SELF, grid_.get(), &vector);
  StructVector made(vector);
  HYPRE_StructVectorInitialize(vector);
  std::vector<double> values;
  for (const CellBox& box : boxes_) {
    values.resize(box.cells());
    visit_box(box, [&](Slot s, std::size_t n) { values[n] = value(s); });
    Index3 low = turned(box.low), high = turned(box.high);
    HYPRE_StructVectorSetBoxValues(vector, low.data(), high.data(), values.data());
  }
  HYPRE_StructVectorAssemble(vector);
  return made;
}

template <class Visit>
void BoxGrid::read(const StructVector& vector, Visit visit) const {
  std::vector<double> values;
  for (const CellBox& box : boxes_) {
    values.resize(box.cells());
    Index3 low = turned(box.low), high = turned(box.high);
    HYPRE_StructVectorGetBoxValues(vector.get(), low.data(), high.data(), values.data());
    visit_box(box, [&](Slot s, std::size_t n) { visit(s, values[n]); });
  }
}

Pfmg made_pfmg() {
  HYPRE_StructSolver pfmg = nullptr;
  HYPRE_StructPFMGCreate(MPI_COMM_SELF, &pfmg);
  Pfmg made(pfmg);
  HYPRE_StructPFMGSetTol(pfmg, kNoTolerance);
  HYPRE_StructPFMGSetMaxIter(pfmg, 1);
  HYPRE_StructPFMGSetZeroGuess(pfmg);
  HYPRE_StructPFMGSetRelaxType(pfmg, 2);  // red-black Gauss–Seidel, the same both ways
  HYPRE_StructPFMGSetRAPType(pfmg, 1);    // coarse grids of seven points too
  HYPRE_StructPFMGSetSkipRelax(pfmg, 1);  // not on grids that coarsened along one axis only
  return made;
}

// Rows of any pattern: HYPRE's IJ interface.

IjMatrix ij_matrix(const SparseRows& from, const SystemScale& scale) {
  const auto rows = static_cast<HYPRE_Int>(from.rows());
  HYPRE_IJMatrix matrix = nullptr;
  HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, rows - 1, 0, rows - 1, &matrix);
  IjMatrix made(matrix);
  HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
  std::vector<HYPRE_Int> counts(from.rows()), columns(from.column.begin(), from.column.end());
  std::vector<HYPRE_Int> numbers(from.rows());
  for (std::size_t r = 0; r < from.rows(); ++r) {
    counts[r] = static_cast<HYPRE_Int>(from.first[r + 1] - from.first[r]);
    numbers[r] = static_cast<HYPRE_Int>(r);
  }
  std::vector<double> values(from.value);
  for (double& v : values) v = std::ldexp(v, -scale.matrix);
  HYPRE_IJMatrixSetRowSizes(matrix, counts.data());
  HYPRE_IJMatrixInitialize(matrix);
  HYPRE_IJMatrixSetValues(matrix, rows, counts.data(), numbers.data(), columns.data(),
                          values.data());
  HYPRE_IJMatrixAssemble(matrix);
  return made;
}

IjVector ij_vector(const std::vector<double>& from, int power) {
  const auto rows = static_cast<HYPRE_Int>(from.size());
  HYPRE_IJVector vector = nullptr;
  HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, rows - 1, &vector);
  IjVector made(vector);
  HYPRE_IJVectorSetObjectType(vector, HYPRE_PARCSR);
  HYPRE_IJVectorInitialize(vector);
  std::vector<double> values(from);
  for (double& v : values) v = std::ldexp(v, power);
  HYPRE_IJVectorSetValues(vector, rows, nullptr, values.data());
  HYPRE_IJVectorAssemble(vector);
  return made;
}

template <class Object, class Handle, class Get>
Object object_of(const Handle& handle, Get get) {
  void* object = nullptr;
  get(handle.get(), &object);
  return static_cast<Object>(object);
}

Amg made_amg(const SparseRows& matrix) {
  HYPRE_Solver amg = nullptr;
  HYPRE_BoomerAMGCreate(&amg);
  Amg made(amg);
  HYPRE_BoomerAMGSetTol(amg, kNoTolerance);
  HYPRE_BoomerAMGSetMaxIter(amg, 1);
  HYPRE_BoomerAMGSetPrintLevel(amg, 0);
  // What HYPRE's manual advises for three dimensions, with a symmetric smoother.
  HYPRE_BoomerAMGSetCoarsenType(amg, 10);  // HMIS
  HYPRE_BoomerAMGSetAggNumLevels(amg, 1);
  HYPRE_BoomerAMGSetInterpType(amg, 6);  // extended+i
  HYPRE_BoomerAMGSetPMaxElmts(amg, 4);
  HYPRE_BoomerAMGSetRelaxType(amg, 6);  // symmetric Gauss–Seidel
  if (!matrix.component.empty()) {
    HYPRE_BoomerAMGSetNumFunctions(amg, 3);
    const std::size_t rows = matrix.component.size();
    auto* component = static_cast<HYPRE_Int*>(std::malloc(rows * sizeof(HYPRE_Int)));
    if (component == nullptr) throw std::bad_alloc();
    std::copy(matrix.component.begin(), matrix.component.end(), component);
    HYPRE_BoomerAMGSetDofFunc(amg, component);  // which HYPRE frees
  }
  return made;
}

}  // namespace

int solve_boxes(const SevenPoint& matrix, const std::vector<CellBox>& boxes, const HypreTask& task,
                std::vector<double>& x) {
  need_mpi();
  const auto& [right, scale, options] = task;
  const BoxGrid grid(*matrix.grid, boxes);
  const StructMatrix a = grid.matrix(matrix, scale);
  const auto of_active = [&](const std::vector<double>& v, int power) {
    return grid.vector(
        [&, power](Slot s) { return matrix.active[s] != 0 ? std::ldexp(v[s], power) : 0.0; });
  };
  const StructVector b = of_active(right, -scale.right);
  const StructVector y = of_active(x, scale.matrix - scale.right);

  const Pfmg cycle = made_pfmg();
  HYPRE_StructSolver handle = nullptr;
  HYPRE_StructPCGCreate(MPI_COMM_SELF, &handle);
  const StructCg cg(handle);
  HYPRE_StructPCGSetTol(handle, options.tolerance);
  HYPRE_StructPCGSetMaxIter(handle, options.most_iterations);
  HYPRE_StructPCGSetTwoNorm(handle, 1);
  HYPRE_StructPCGSetPrecond(handle, HYPRE_StructPFMGSolve, HYPRE_StructPFMGSetup, cycle.get());
  HYPRE_StructPCGSetup(handle, a.get(), b.get(), y.get());
  HYPRE_StructPCGSolve(handle, a.get(), b.get(), y.get());
  HYPRE_Int done = 0;
  HYPRE_StructPCGGetNumIterations(handle, &done);
  check_hypre();

  std::vector<double> found = x;
  const int power = scale.right - scale.matrix;
  grid.read(y, [&](Slot s, double value) {
    if (matrix.active[s] != 0) found[s] = std::ldexp(value, power);
  });
  if (all_finite(found)) x = std::move(found);
  return done;
}

int solve_rows(const SparseRows& matrix, RowsMethod method, const HypreTask& task,
               std::vector<double>& x) {
  need_mpi();
  const auto& [right, scale, options] = task;
  const IjMatrix a = ij_matrix(matrix, scale);
  const IjVector b = ij_vector(right, -scale.right);
  const IjVector y = ij_vector(x, scale.matrix - scale.right);
  const auto pa = object_of<HYPRE_ParCSRMatrix>(a, HYPRE_IJMatrixGetObject);
  const auto pb = object_of<HYPRE_ParVector>(b, HYPRE_IJVectorGetObject);
  const auto py = object_of<HYPRE_ParVector>(y, HYPRE_IJVectorGetObject);

  const Amg amg = method == RowsMethod::kAmg ? made_amg(matrix) : nullptr;
  HYPRE_Solver handle = nullptr;
  HYPRE_ParCSRPCGCreate(MPI_COMM_SELF, &handle);
  const RowsCg cg(handle);
  HYPRE_PCGSetTol(handle, options.tolerance);
  HYPRE_PCGSetMaxIter(handle, options.most_iterations);
  HYPRE_PCGSetTwoNorm(handle, 1);
  if (amg)
    HYPRE_ParCSRPCGSetPrecond(handle, HYPRE_BoomerAMGSolve, HYPRE_BoomerAMGSetup, amg.get());
  else
    HYPRE_ParCSRPCGSetPrecond(handle, HYPRE_ParCSRDiagScale, HYPRE_ParCSRDiagScaleSetup, nullptr);
  HYPRE_ParCSRPCGSetup(handle, pa, pb, py);
  HYPRE_ParCSRPCGSolve(handle, pa, pb, py);
  HYPRE_Int done = 0;
  HYPRE_PCGGetNumIterations(handle, &done);
  check_hypre();
  std::vector<double> found(x.size());
  HYPRE_IJVectorGetValues(y.get(), static_cast<HYPRE_Int>(x.size()), nullptr, found.data());
  for (double& value : found) value = std::ldexp(value, scale.right - scale.matrix);
  if (all_finite(found)) x = std::move(found);
  return done;
}

}  // namespace suture::sims
