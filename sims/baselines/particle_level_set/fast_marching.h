// Level sets made distances again by the fast marching method, first order [Sethian 1996].
#pragma once

#include "sims/baselines/grid/dense_level_set.h"

namespace suture::sims {

/// Newton steps towards the zero of the trilinear φ, from the nodes next to it. The numbers are
/// those of PhysBAM, the code of the particle level set's authors, but for the tolerance, which is
/// 0.01 there.
struct ClosestPoint {
  int steps = 10;
  double tolerance = 1e-3;  ///< cells that the end may be off the surface
  double drift = 0.1;  ///< the part of the plane's distance that the end may be farther than it
};

/// Makes φ the distance to its zero set at all nodes within set.width, and ± width elsewhere; no
/// node changes sides. A node next to the surface takes its distance from the end of closest-point
/// steps, or from the plane through the zeros on its edges, and φ is scaled to these. That moves a
/// ball of radius r by 0.024/r cells once, and hardly when repeated; unscaled distances move it by
/// 0.09/r inwards, each time. Beyond them |∇φ| = 1 by upwind differences, from the nearest
/// outwards.
void march_distances(DenseLevelSet& set, const ClosestPoint& closest = {});

}  // namespace suture::sims
