// The rigid motions of connected bodies, which viscous stress leaves alone.
#pragma once

#include <vector>

#include "sims/fluid/effects/stress/viscous_system.h"

namespace suture::sims {

/// The bodies that terms connect, and a correction of each by a rigid motion.
class RigidPart {
 public:
  explicit RigidPart(const ViscousSystem& system);

  /// Adds to each body the rigid motion that makes the system's energy least: the momenta of a free
  /// body become those before the step, to rounding, at any stiffness.
  void correct(std::vector<double>& v) const;

  std::size_t bodies() const { return bodies_.size(); }
  std::size_t memory() const;

 private:
  using Modes = Eigen::Matrix<double, 6, 1>;  // three translations, three rotations
  struct Body {
    Point centre = Point::Zero();
    double size = 0;
    double mass = 0;
  };
  Modes modes(std::uint32_t unknown) const;
  Modes modes(const ViscousSystem::Term& term) const;
  std::uint32_t body(const ViscousSystem::Term& term) const;

  const ViscousSystem* system_;
  std::vector<std::uint32_t> body_of_;
  std::vector<Body> bodies_;
  std::vector<Eigen::Matrix<double, 6, 6>>
      basis_;  // columns of mass 1 and orthogonal by mass, or 0
};

}  // namespace suture::sims
