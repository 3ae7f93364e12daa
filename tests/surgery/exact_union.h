// The exact union of closed surfaces, by CGAL's corefinement: the judge of remodelled volumes.
#pragma once

#include "kernel/triangles.h"

namespace suture {

/// Volume of the union of two closed, outward, non-self-intersecting surfaces.
/// \throw InternalFailure if corefinement cannot make it
double exact_union_volume(const Triangles& a, const Triangles& b);

}  // namespace suture
