// MacCormack's semi-Lagrangian step in a narrow band: forth, back, and half the error [Selle 2008].
#pragma once

#include "sims/baselines/grid/level_set_grid.h"
#include "sims/baselines/grid/paths.h"
#include "sims/baselines/level_set/level_set_options.h"

namespace suture::sims {

struct MacCormackStep {
  PathStep path;
  Limiter limiter = Limiter::clamp;
};

/// The band at time + dt. A node is corrected only where all values that its correction stands on
/// are within the band: at its border, where φ is cut off, the error is that of the cut.
/// \throw InvalidInput where u is not finite or a path is longer than 1000 cells
openvdb::FloatGrid::Ptr mac_cormack(const openvdb::FloatGrid& grid, const GridVelocity& u,
                                    const MacCormackStep& step);

}  // namespace suture::sims
