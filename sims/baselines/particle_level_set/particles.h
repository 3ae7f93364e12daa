// The particles of the particle level set: seeded round the surface, attracted, carried, re-seeded
// [Enright et al. 2002].
#pragma once

#include "kernel/random.h"
#include "sims/baselines/grid/dense_level_set.h"
#include "sims/baselines/grid/paths.h"

namespace suture::sims {

/// A ball that touches the surface from its own side, or lies on that side.
struct Particle {
  Point position;     ///< cells from the grid's origin
  double radius = 0;  ///< cells
  double side = 1;    ///< 1: outside, −1: inside
};

/// Lengths are in cells.
struct ParticleRules {
  int per_cell = 64;
  double band = 3;
  double smallest_radius = 0.1, largest_radius = 0.5;
  double escape = 1;  ///< radii
  int attraction_steps = 15;
};

/// Whether the particle lies on the wrong side by more than rules.escape radii; `phi` is φ at its
/// place [§3.3].
inline bool escaped(const Particle& particle, double phi, const ParticleRules& rules) {
  return -particle.side * phi > rules.escape * particle.radius;
}

/// Each radius becomes the distance to the surface on the particle's own side, within the bounds;
/// an escaped one has the smallest [§3.1].
void adjust_radii(std::vector<Particle>& particles, const DenseLevelSet& set,
                  const ParticleRules& rules);

/// Moves the particles along u. \throw InvalidInput if one comes to lie nowhere finite
void carry(std::vector<Particle>& particles, const GridVelocity& u, const PathStep& step);

/// Throws away the particles that have not escaped and whose cell has no corner on their side in
/// the band, and the farthest of more than per_cell of one side in a cell; adds to the cells with a
/// corner in the band until they have per_cell of both sides together [§3.1, §3.5]. With no
/// particles this is the first seeding. The result is in the order of the cells.
void reseed(std::vector<Particle>& particles, const DenseLevelSet& set, const ParticleRules& rules,
            Random& random);

}  // namespace suture::sims
