// Level sets made distances again by the fast marching method, first order [Sethian 1996].
#pragma once

#include "sims/baselines/grid/dense_level_set.h"

namespace suture::sims {

/// Newton steps towards the zero of the trilinear φ, from the nodes next to it. The numbers are
/// those of PhysBAM, the code of the particle level set's authors, but for the tolerance, there
/// 0.01.
struct ClosestPoint {
  int steps = 10;
  double tolerance = 1e-3;  ///< cells that the end may be off the surface
  double drift = 0.1;  ///< the most, as a part, that it may be further than the plane's distance
};

/// Distances to the zero set of φ, at all nodes within set.width; ± width elsewhere; no node
/// changes sides. Next to the surface: to the plane through the zeros on the node's edges, or
/// better the end of closest-point steps; then φ is scaled to these. That moves a ball of radius r
/// by 0.024/r cells once, and hardly when repeated; taken as they are, by 0.09/r inwards at first
/// and on and on. Beyond: |∇φ| = 1 by upwind differences, from the nearest outwards.
void march_distances(DenseLevelSet& set, const ClosestPoint& closest = {});

}  // namespace suture::sims
