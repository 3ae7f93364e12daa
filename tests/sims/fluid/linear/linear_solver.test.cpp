#include "sims/fluid/linear/linear_solver.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "kernel/errors.h"
#include "kernel/random.h"
#include "sims/fluid/grid/cell_boxes.h"
#include "tests/sims/fluid/cells.h"

using namespace suture;
using namespace suture::sims;

namespace {

/// Cells of a box where keep(cell) holds, as a Laplacian with air, at a random depth, all round.
template <class Keep>
SevenPoint laplacian(const SharedGrid& grid, Keep keep, std::uint64_t seed = 1) {
  Random random(seed);
  SevenPoint m(grid);
  for (Slot s = 0; s < grid->size(); ++s) m.active[s] = keep(grid->cell(s)) ? 1 : 0;
  for (Slot s = 0; s < grid->size(); ++s) {
    if (m.active[s] == 0) continue;
    for (int a = 0; a < 3; ++a)
      for (const int side : {-1, 1}) {
        const Slot n = grid->neighbour(s, a, side);
        const bool inside = n != kNoSlot && m.active[n] != 0;
        m.diagonal[s] += inside ? 1 : 1 / random.uniform(0.001, 1);
        if (inside && side < 0) m.low[a][s] = -1;
      }
  }
  return m;
}

std::vector<double> noise(const SevenPoint& m, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> b(m.active.size(), 0);
  for (Slot s = 0; s < b.size(); ++s)
    if (m.active[s] != 0) b[s] = random.uniform(-1, 1);
  return b;
}

Eigen::SparseMatrix<double> matrix_of(const SevenPoint& m) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Slot s = 0; s < m.active.size(); ++s) {
    const auto row = static_cast<int>(s);
    entries.emplace_back(row, row, m.active[s] != 0 ? m.diagonal[s] : 1);
    for (int a = 0; a < 3; ++a) {
      if (m.low[a][s] == 0) continue;
      const auto column = static_cast<int>(m.grid->neighbour(s, a, -1));
      entries.emplace_back(row, column, m.low[a][s]);
      entries.emplace_back(column, row, m.low[a][s]);
    }
  }
  const auto n = static_cast<int>(m.active.size());
  Eigen::SparseMatrix<double> made(n, n);
  made.setFromTriplets(entries.begin(), entries.end());
  return made;
}

SparseRows rows_of(const Eigen::SparseMatrix<double>& m) {
  SparseRows rows;
  rows.first.push_back(0);
  for (int r = 0; r < m.outerSize(); ++r) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(m, r); it; ++it) {
      rows.column.push_back(static_cast<std::uint32_t>(it.row()));
      rows.value.push_back(it.value());
    }
    rows.first.push_back(rows.column.size());
  }
  return rows;
}

double furthest(const std::vector<double>& x, const Eigen::VectorXd& exact) {
  double most = 0;
  for (std::size_t n = 0; n < x.size(); ++n)
    most = std::max(most, std::abs(x[n] - exact[static_cast<Eigen::Index>(n)]));
  return most / exact.lpNorm<Eigen::Infinity>();
}

double norm(const Index3& c) { return std::hypot(c[0], c[1], c[2]); }

}  // namespace

TEST_CASE("both solvers agree with Eigen's direct one on a ball of cells") {
  const SharedGrid grid = shared_grid(Point::Zero(), 1, cells_in({-11, -11, -11}, {11, 11, 11}));
  const SevenPoint m = laplacian(grid, [](const Index3& c) { return norm(c) < 10.3; });
  const std::vector<double> b = noise(m, 2);
  const Eigen::SparseMatrix<double> a = matrix_of(m);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> direct(a);
  const Eigen::VectorXd exact =
      direct.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), static_cast<int>(b.size())));
  SolverOptions options;
  options.tolerance = 1e-12;
  std::vector<double> x;
  const SolveReport report = solve(m, b, x, options);
  CHECK(report.residual <= 1e-12);
  CHECK(report.iterations < 40);  // 24 measured
  CHECK(furthest(x, exact) < 1e-10);
  std::vector<double> y;
  CHECK(solve(rows_of(a), b, y, options).residual <= 1e-12);
  CHECK(furthest(y, exact) < 1e-10);
}

TEST_CASE("a system solved twice gives the same bits, and one solved already takes no iteration") {
  const SharedGrid grid = shared_grid(Point::Zero(), 1, cells_in({0, 0, 0}, {20, 15, 9}));
  const SevenPoint m = laplacian(grid, [](const Index3&) { return true; });
  const std::vector<double> b = noise(m, 3);
  std::vector<double> x, y;
  CHECK(solve(m, b, x).converged());
  CHECK(solve(m, b, y).converged());
  CHECK((x == y));
  CHECK(solve(m, b, x).iterations == 0);
  CHECK((x == y));
}

TEST_CASE("the unit of a system does not matter to its solution, however far from 1") {
  const SharedGrid grid = shared_grid(Point::Zero(), 1, cells_in({0, 0, 0}, {15, 15, 15}));
  const auto all = [](const Index3&) { return true; };
  const std::vector<double> b = noise(laplacian(grid, all), 4);
  std::vector<double> x;
  CHECK(solve(laplacian(grid, all), b, x).converged());
  for (const int power : {-500, 500}) {
    SevenPoint m = laplacian(grid, all);
    for (double& d : m.diagonal) d = std::ldexp(d, power);
    for (auto& low : m.low)
      for (double& d : low) d = std::ldexp(d, power);
    std::vector<double> scaled(b), y;
    for (double& v : scaled) v = std::ldexp(v, -power / 2);
    CHECK(solve(m, scaled, y).residual <= 1e-6);
    for (double& v : y) v = std::ldexp(v, power + power / 2);
    CHECK((x == y));
  }
}

TEST_CASE("no unknowns and a right side of zeros are solved by zeros") {
  std::vector<double> x;
  CHECK(solve(SevenPoint(), {}, x).iterations == 0);
  CHECK(solve(SparseRows(), {}, x).iterations == 0);
  const SharedGrid grid = shared_grid(Point::Zero(), 1, {{0, 0, 0}});
  SevenPoint m(grid);
  const std::vector<double> zeros(grid->size(), 0);
  x.assign(grid->size(), 7);
  CHECK(solve(m, zeros, x).residual == 0);
  CHECK((x == zeros));
  m.active[3] = 1;
  m.diagonal[3] = 2;
  x.assign(grid->size(), 7);
  CHECK(solve(m, zeros, x).iterations == 0);
  CHECK((x == zeros));
  std::vector<double> b(zeros);
  b[3] = 5;
  CHECK(solve(m, b, x).residual <= 1e-6);
  CHECK(x[3] == Approx(2.5));
}

TEST_CASE("numbers that are not finite, and sizes that do not fit, are refused") {
  const SharedGrid grid = shared_grid(Point::Zero(), 1, {{0, 0, 0}});
  SevenPoint m(grid);
  m.active[3] = 1;
  m.diagonal[3] = 2;
  std::vector<double> b(grid->size(), 0), x;
  b[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(solve(m, b, x), InvalidInput);
  b[3] = 1;
  m.diagonal[3] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(solve(m, b, x), InvalidInput);
  m.diagonal[3] = 0;
  CHECK_THROWS_AS(solve(m, b, x), InvalidInput);
  m.diagonal[3] = 1;
  b.pop_back();
  CHECK_THROWS_AS(solve(m, b, x), InvalidInput);
  SparseRows rows;
  rows.first = {0, 1};
  rows.column = {0};
  rows.value = {1};
  CHECK_THROWS_AS(solve(rows, {std::numeric_limits<double>::infinity()}, x), InvalidInput);
  CHECK_THROWS_AS(solve(rows, {1, 2}, x), InvalidInput);
}

TEST_CASE("two bodies ten thousand cells apart cost what two bodies cost") {
  const auto system = [](int apart) {
    std::vector<Index3> cells = cells_in({0, 0, 0}, {15, 15, 15});
    for (const Index3& c : cells_in({apart, apart, apart}, {apart + 15, apart + 15, apart + 15}))
      cells.push_back(c);
    return shared_grid(Point::Zero(), 1, cells);
  };
  const SharedGrid close = system(32), far = system(10000);
  CHECK(far->size() == close->size());
  for (const SharedGrid& grid : {close, far}) {
    const SevenPoint m = laplacian(grid, [](const Index3&) { return true; });
    const std::vector<CellBox> boxes = active_boxes(*grid, m.active);
    REQUIRE(boxes.size() == 2);
    CHECK(boxes[0].cells() + boxes[1].cells() == grid->size());
    std::vector<double> x;
    const SolveReport report = solve(m, noise(m, 5), x);
    CHECK(report.residual <= 1e-6);
    CHECK(report.iterations < 20);
  }
}

TEST_CASE("scattered drops, which boxes would hold badly, are solved as well") {
  std::vector<Index3> cells;
  Random random(7);
  for (int n = 0; n < 400; ++n) {
    const int x = static_cast<int>(random.below(400)), y = static_cast<int>(random.below(400));
    const int z = static_cast<int>(random.below(400));
    for (const Index3& c : cells_in({x, y, z}, {x + 2, y + 2, z + 2})) cells.push_back(c);
  }
  const SharedGrid grid = shared_grid(Point::Zero(), 1, cells);
  std::vector<std::uint8_t> wet(grid->size(), 0);
  for (const Index3& c : cells) wet[grid->find(c)] = 1;
  const SevenPoint m = laplacian(grid, [&](const Index3& c) { return wet[grid->find(c)] != 0; });
  std::vector<double> x;
  CHECK(solve(m, noise(m, 8), x).residual <= 1e-6);
}

TEST_CASE("diffusion is solved however stiff it is, in no more iterations than are worth it") {
  const int n = 24;
  std::vector<Index3> cells = cells_in({0, 0, 0}, {n - 1, n - 1, n - 1});
  const SharedGrid grid = shared_grid(Point::Zero(), 1, cells);
  for (const double k : {0.01, 1.0, 100.0, 1e6}) {
    SevenPoint m(grid);
    m.active.assign(grid->size(), 1);
    m.diagonal.assign(grid->size(), 1);
    for (Slot s = 0; s < grid->size(); ++s)
      for (int a = 0; a < 3; ++a) {
        const Slot below = grid->neighbour(s, a, -1);
        if (below == kNoSlot) continue;
        m.low[a][s] = -k;
        m.diagonal[s] += k;
        m.diagonal[below] += k;
      }
    std::vector<double> x;
    const SolveReport report = solve(rows_of(matrix_of(m)), noise(m, 9), x);
    CHECK(report.residual <= 1e-6);
    CHECK(report.iterations < 160);  // 140 measured, 48 for the stiffest
  }
}

TEST_CASE(
    "a solve that runs out of iterations or finds no way on says which, and keeps what it has") {
  const SharedGrid grid = shared_grid(Point::Zero(), 1, cells_in({0, 0, 0}, {15, 15, 15}));
  const SevenPoint m = laplacian(grid, [](const Index3&) { return true; });
  const std::vector<double> b = noise(m, 10);
  const SparseRows rows = rows_of(matrix_of(m));
  SolverOptions one;
  one.most_iterations = 1;
  const auto check = [&](const auto& matrix) {
    std::vector<double> x;
    const SolveReport report = solve(matrix, b, x, one);
    CHECK(report.status == SolveStatus::iterations_exhausted);
    CHECK_FALSE(report.converged());
    CHECK(report.iterations == 1);
    CHECK(report.residual > one.tolerance);
    CHECK(report.residual < 1);  // the one iteration is kept
    CHECK(solve(matrix, b, x).converged());
  };
  check(m);
  check(rows);
  // Singular, with a right side that no x gives: the first step has no length.
  const SparseRows singular{{0, 2, 4}, {0, 1, 0, 1}, {1, -1, -1, 1}, {}};
  std::vector<double> x;
  const SolveReport none = solve(singular, {1, 1}, x);
  CHECK(none.status == SolveStatus::broken_down);
  CHECK(none.residual > SolverOptions().tolerance);
  for (const double value : x) CHECK(std::isfinite(value));
}
