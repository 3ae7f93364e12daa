// Which bodies of liquid after a remodel are which before it, whatever merged and split.
#pragma once

#include "sims/fluid/liquid/liquid_bodies.h"

namespace suture::sims {

/// Bodies before and after a change in groups that hold the same liquid: one to one where nothing
/// happened, several to one for a merge, one to several for a split.
struct ComponentGroups {
  std::vector<std::uint32_t> before, after;  ///< the group of each body
  std::size_t count = 0;
};

/// A surface and the bodies that it bounds. Keeps references to them.
struct SurfaceBodies {
  const Triangles& surface;
  const LiquidBodies& bodies;
};

/// Bodies that share a vertex, to the last bit, are of one group. One that shares none is asked
/// which it is near: of up to 64 of its vertices those count that are no further from the other
/// surface than it is wide, and a body that an eighth of the 64 are nearest to is of its group.
ComponentGroups track_components(const SurfaceBodies& before, const SurfaceBodies& after);

}  // namespace suture::sims
