// The steps of the particle level set of 2002, by OpenVDB: WENO advection and relaxation.
#pragma once

#include "sims/baselines/grid/dense_level_set.h"
#include "sims/baselines/grid/paths.h"

namespace suture::sims {

/// A step from `time` to time + dt; `cover` is as for BackTrace.
struct WenoStep {
  double time = 0, dt = 0;
  Box cover{Point::Constant(1), Point::Constant(0)};
};

/// Fifth-order upwind WENO and third-order TVD Runge–Kutta [Enright et al. 2002, §2], in as many
/// sub-steps as are stable; single precision. \throw InvalidInput as semi_lagrangian
DenseLevelSet weno_advected(const DenseLevelSet& old, const GridVelocity& u, const WenoStep& step);

/// Relaxed towards |∇φ| = 1 by the same schemes, in pseudo-time steps of about a cell [Sussman,
/// Smereka and Osher 1994]. \pre steps >= 1
DenseLevelSet weno_relaxed(const DenseLevelSet& old, int steps, const Box& cover);

}  // namespace suture::sims
