// Mean curvature flow by one implicit step of the cotangent operator [Desbrun et al. 1999].
#include "sims/flows/mean_curvature.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Twice a triangle's area counts as at least this part of its longest edge squared. Its three
// cotangents shrink together, so its part of the matrix stays positive semi-definite.
constexpr double kThinnest = 1e-5;

struct System {
  std::vector<Eigen::Triplet<double>> stiffness;
  Eigen::VectorXd mass;
};

/// The three half cotangents and the lumped mass of one triangle.
void add_triangle(const Triangles& surface, const Triangle& triangle, System& system) {
  const auto& x = surface.positions;
  double longest = 0;
  for (int i = 0; i < 3; ++i)
    longest = std::max(longest, (x[triangle[(i + 1) % 3]] - x[triangle[i]]).squaredNorm());
  const double twice_area =
      (x[triangle[1]] - x[triangle[0]]).cross(x[triangle[2]] - x[triangle[0]]).norm();
  const double divisor = std::max(twice_area, kThinnest * longest);
  if (!(divisor > 0)) return;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t at = triangle[i], a = triangle[(i + 1) % 3], b = triangle[(i + 2) % 3];
    const double w = 0.5 * (x[a] - x[at]).dot(x[b] - x[at]) / divisor;
    system.stiffness.emplace_back(a, a, w);
    system.stiffness.emplace_back(b, b, w);
    system.stiffness.emplace_back(a, b, -w);
    system.stiffness.emplace_back(b, a, -w);
    system.mass[at] += twice_area / 6;
  }
}

}  // namespace

std::vector<Point> mean_curvature_flow(const Triangles& surface, double time) {
  const auto n = static_cast<Eigen::Index>(surface.positions.size());
  if (n == 0) return {};
  System system{{}, Eigen::VectorXd::Zero(n)};
  system.stiffness.reserve(12 * surface.triangles.size());
  for (const Triangle& triangle : surface.triangles) add_triangle(surface, triangle, system);
  // A vertex among triangles without area has no mass of its own and follows its neighbours.
  const double least = 1e-6 * system.mass.mean();
  system.mass = system.mass.cwiseMax(least > 0 ? least : 1.0);

  Matrix matrix(n, n);
  matrix.setFromTriplets(system.stiffness.begin(), system.stiffness.end());
  // Where stiff terms cancel, a mass that is lost in their rounding leaves a pivot that is zero.
  constexpr double kNotLost = 1e-9;
  system.mass = system.mass.cwiseMax(kNotLost * time * Eigen::VectorXd(matrix.diagonal()));
  matrix = time * matrix + Matrix(system.mass.asDiagonal());
  Eigen::MatrixX3d right(n, 3);
  for (Eigen::Index v = 0; v < n; ++v)
    right.row(v) = system.mass[v] * surface.positions[static_cast<std::size_t>(v)].transpose();

  const Eigen::SimplicialLDLT<Matrix> solver(matrix);
  if (solver.info() != Eigen::Success)
    throw InternalFailure("mean curvature flow", "the implicit step's matrix is singular");
  const Eigen::MatrixX3d solution = solver.solve(right);
  std::vector<Point> moved(surface.positions.size());
  for (Eigen::Index v = 0; v < n; ++v)
    moved[static_cast<std::size_t>(v)] = solution.row(v).transpose();
  return moved;
}

}  // namespace suture::sims
