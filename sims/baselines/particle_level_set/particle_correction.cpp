// Escaped particles rebuild φ at the corners of their cells.
#include "sims/baselines/particle_level_set/particle_correction.h"

#include "kernel/sparse_field.h"

namespace suture::sims {
namespace {

struct Rebuilt {
  double plus = 0, minus = 0;
};

void rebuild_corners(SparseField<Rebuilt>& nodes, const DenseLevelSet& set,
                     const Particle& particle) {
  Index3 cell;
  for (int a = 0; a < 3; ++a) cell[a] = static_cast<int>(std::floor(particle.position[a]));
  for (int corner = 0; corner < 8; ++corner) {
    const Index3 node{cell[0] + (corner >> 2), cell[1] + (corner >> 1 & 1), cell[2] + (corner & 1)};
    const std::size_t at = set.box.at(node), known = nodes.size();
    Rebuilt& phi = nodes[at];
    if (nodes.size() > known) phi = {set.phi[at], set.phi[at]};
    const double distance = (particle.position - Point(node[0], node[1], node[2])).norm();
    const double ball = particle.side * (particle.radius - distance);
    if (particle.side > 0)
      phi.plus = std::max(phi.plus, ball);
    else
      phi.minus = std::min(phi.minus, ball);
  }
}

}  // namespace

std::size_t correct(DenseLevelSet& set, const std::vector<Particle>& particles,
                    const ParticleRules& rules) {
  SparseField<Rebuilt> nodes;
  std::size_t count = 0;
  for (const Particle& m : particles)
    if (escaped(m, set.sample(m.position), rules)) {
      ++count;
      rebuild_corners(nodes, set, m);
    }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto [plus, minus] = nodes.values()[i];
    set.phi[nodes.keys()[i]] = std::abs(plus) <= std::abs(minus) ? plus : minus;
  }
  return count;
}

}  // namespace suture::sims
