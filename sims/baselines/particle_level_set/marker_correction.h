// The level set rebuilt from the markers that it let escape [Enright et al. 2002, §3.3].
#pragma once

#include "sims/baselines/particle_level_set/marker_particles.h"

namespace suture::sims {

/// Each escaped marker's ball is a level set s·(r − |x − x_p|). φ⁺ is the greatest of φ and those
/// of the escaped outer markers, φ⁻ the least of φ and those of the inner ones, each at the corners
/// of the marker's cell; φ becomes the one with the smaller magnitude. \return how many markers
/// had escaped \pre the corners of every marker's cell are nodes of the box, off its border
std::size_t correct(DenseLevelSet& set, const std::vector<Marker>& markers,
                    const MarkerRules& rules);

}  // namespace suture::sims
