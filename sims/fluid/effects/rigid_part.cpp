// The rigid motions of connected bodies, which viscous stress leaves alone.
#include "sims/fluid/effects/rigid_part.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "kernel/union_find.h"

namespace suture::sims {
namespace {

using Square = Eigen::Matrix<double, 6, 6>;

/// Of a body's six motions' masses, as parts of the largest: motions that its few faces cannot tell
/// apart have masses of rounding; real ones are above a small share's.
constexpr double kLeastMode = 1e-10;

/// The body of each unknown, numbered by their first unknowns.
std::vector<std::uint32_t> connected(const ViscousSystem& system, std::size_t& count) {
  UnionFind sets(system.faces.size());
  for (const ViscousSystem::Term& t : system.terms) {
    std::uint32_t first = kNone;
    for (const std::uint32_t u : t.unknown) {
      if (u == kNone) continue;
      if (first == kNone) first = u;
      sets.join(first, u);
    }
  }
  count = 0;
  std::vector<std::uint32_t> body(sets.size());
  for (std::uint32_t i = 0; i < body.size(); ++i) {
    const std::uint32_t r = sets.root(i);
    body[i] = r == i ? static_cast<std::uint32_t>(count++) : body[r];
  }
  return body;
}

}  // namespace

RigidPart::RigidPart(const ViscousSystem& system) : system_(&system) {
  const SparseGrid& grid = *system.grid;
  std::size_t count = 0;
  body_of_ = connected(system, count);
  bodies_.resize(count);
  const auto place = [&](std::uint32_t i) {
    return grid.face(grid.cell(system.faces[i].slot), system.faces[i].axis);
  };
  for (std::uint32_t i = 0; i < body_of_.size(); ++i) {
    bodies_[body_of_[i]].centre += system.mass[i] * place(i);
    bodies_[body_of_[i]].mass += system.mass[i];
  }
  for (Body& b : bodies_) {  // one without mass has no motion of its own, and may be anywhere
    b.centre = b.mass > 0 ? Point(b.centre / b.mass) : Point(Point::Zero());
    b.size = grid.h();
  }
  for (std::uint32_t i = 0; i < body_of_.size(); ++i) {
    Body& b = bodies_[body_of_[i]];
    b.size = std::max(b.size, (place(i) - b.centre).norm());
  }
  basis_.assign(count, Square::Zero());
  for (std::uint32_t i = 0; i < body_of_.size(); ++i) {
    const Modes m = modes(i);
    basis_[body_of_[i]] += system.mass[i] * m * m.transpose();
  }
  for (Square& b : basis_) {
    const Eigen::SelfAdjointEigenSolver<Square> own(b);
    const double least = kLeastMode * own.eigenvalues()[5];
    b.setZero();
    for (int n = 0; n < 6; ++n)
      if (own.eigenvalues()[n] > least)
        b.col(n) = own.eigenvectors().col(n) / std::sqrt(own.eigenvalues()[n]);
  }
}

RigidPart::Modes RigidPart::modes(std::uint32_t unknown) const {
  const ViscousSystem::Face& f = system_->faces[unknown];
  const Body& b = bodies_[body_of_[unknown]];
  const Point arm = (system_->grid->face(system_->grid->cell(f.slot), f.axis) - b.centre) / b.size;
  const int next = next_axis(f.axis), prev = prev_axis(f.axis);
  Modes m = Modes::Zero();
  m[f.axis] = 1;
  m[3 + next] = arm[prev];
  m[3 + prev] = -arm[next];
  return m;
}

RigidPart::Modes RigidPart::modes(const ViscousSystem::Term& term) const {
  Modes m = Modes::Zero();
  for (int n = 0; n < 4; ++n)
    if (term.unknown[n] != kNone) m += term.way[n] * modes(term.unknown[n]);
  return m;
}

std::uint32_t RigidPart::body(const ViscousSystem::Term& term) const {
  for (const std::uint32_t u : term.unknown)
    if (u != kNone) return body_of_[u];
  return kNone;
}

void RigidPart::correct(std::vector<double>& v) const {
  std::vector<Modes> force(bodies_.size(), Modes::Zero());
  std::vector<Square> matrix(bodies_.size(), Square::Identity());
  for (std::uint32_t i = 0; i < body_of_.size(); ++i)
    force[body_of_[i]] += system_->mass[i] * (system_->before[i] - v[i]) * modes(i);
  for (Modes& f : force) f = basis_[&f - force.data()].transpose() * f;
  for (const ViscousSystem::Term& t : system_->terms) {
    if (!t.wall) continue;  // of all others the strain rate of a rigid motion is 0
    const std::uint32_t b = body(t);
    const Modes m = basis_[b].transpose() * modes(t);
    force[b] -= t.stiffness * (t.of(v) + t.constant) * m;
    matrix[b] += t.stiffness * m * m.transpose();
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    force[b] = basis_[b] * matrix[b].ldlt().solve(force[b]);
  for (std::uint32_t i = 0; i < body_of_.size(); ++i) v[i] += force[body_of_[i]].dot(modes(i));
}

std::size_t RigidPart::memory() const {
  return body_of_.capacity() * sizeof(std::uint32_t) + bodies_.capacity() * sizeof(Body) +
         basis_.capacity() * sizeof(Square) +
         bodies_.size() * (sizeof(Square) + sizeof(Modes));  // while it corrects
}

}  // namespace suture::sims
