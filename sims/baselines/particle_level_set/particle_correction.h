// The level set rebuilt from the particles that it let escape [Enright et al. 2002, §3.3].
#pragma once

#include "sims/baselines/particle_level_set/particles.h"

namespace suture::sims {

/// Each escaped particle's ball is a level set s·(r − |x − x_p|). φ⁺ is the greatest of φ and those
/// of the escaped outer particles, φ⁻ the least of φ and those of the inner ones, each at the
/// corners of the particle's cell; φ becomes the one with the smaller magnitude. \return how many
/// particles had escaped \pre the corners of every particle's cell are nodes of the box, off its
/// border
std::size_t correct(DenseLevelSet& set, const std::vector<Particle>& particles,
                    const ParticleRules& rules);

}  // namespace suture::sims
