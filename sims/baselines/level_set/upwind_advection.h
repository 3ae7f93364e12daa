// OpenVDB's level set tracker [Museth 2013]: upwind advection in a narrow band, re-normalised.
#pragma once

#include "sims/baselines/grid/level_set_grid.h"
#include "sims/baselines/grid/paths.h"
#include "sims/baselines/level_set/level_set_options.h"

namespace suture::sims {

/// The longest sub-step, as a part of the time in which the fastest node crosses a cell.
double courant_number(int time_order);

/// Moves the band from `time` on for `dt`, in as many sub-steps as the method needs if dt is too
/// long for one; u is taken at time + dt/2. Then, if asked, re-normalises. The band follows.
struct UpwindStep {
  double time = 0, dt = 0;
  bool renormalise = true;
};
void advect_upwind(openvdb::FloatGrid& grid, const GridVelocity& u, const UpwindStep& step,
                   const LevelSetOptions& options);

/// Widens the band by a node, relaxes it, and drops what is beyond.
void renormalise(openvdb::FloatGrid& grid, const Renormalisation& options);

/// The greatest |u|, in cells a unit of time, over every eighth node of the band.
double fastest(const openvdb::FloatGrid& grid, const GridVelocity& u, double time);

}  // namespace suture::sims
