// First-order semi-Lagrangian motion of a level set [Courant, Isaacson and Rees 1952; Enright
// 2005].
#pragma once

#include "sims/baselines/grid/dense_level_set.h"
#include "sims/baselines/grid/paths.h"

namespace suture::sims {

struct BackTrace {
  PathStep path;  ///< the level set's step forward
  /// A box, in cells, that the new level set has to cover even if no surface comes there; may be
  /// empty, low > high.
  Box cover{Point::Constant(1), Point::Constant(0)};
};

/// φ(x, t + dt) = φ(path back from x, t), trilinear, at all nodes within `width` of the surface;
/// elsewhere ± width. Steps may be longer than cells: what the longest path needs is looked at.
/// \throw InvalidInput if u is not finite or leads out of what indices hold
DenseLevelSet semi_lagrangian(const DenseLevelSet& old, const GridVelocity& u,
                              const BackTrace& trace);

}  // namespace suture::sims
