// Mean curvature flow by one implicit step of the cotangent operator [Desbrun et al. 1999].
#pragma once

#include "kernel/triangles.h"

namespace suture::sims {

/// Positions after the surface has moved for `time` with the normal velocity −(κ₁ + κ₂), so that a
/// sphere shrinks as r² = r₀² − 4·time. Backward Euler: stable for any `time` >= 0, first order.
/// Triangles without area are accepted. \throw InternalFailure if the linear system cannot be
/// solved
std::vector<Point> mean_curvature_flow(const Triangles& surface, double time);

}  // namespace suture::sims
