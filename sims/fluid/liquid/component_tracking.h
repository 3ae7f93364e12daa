// Which bodies of liquid after a remodel are which before it, whatever merged and split.
#pragma once

#include "sims/fluid/liquid/liquid_bodies.h"

namespace suture::sims {

/// Bodies before and after a change in groups that hold the same liquid: one to one where nothing
/// happened, several to one for a merge, one to several for a split.
struct BodyGroups {
  std::vector<std::uint32_t> before, after;  ///< the group of each body
  std::size_t count = 0;
};

/// Bodies that share a vertex, to the last bit, are of one group. One that shares none is asked
/// which it is near: of up to 64 of its vertices those count that are no further from the other
/// surface than it is wide, and a body that an eighth of the 64 are nearest to is of its group.
BodyGroups body_groups(const Triangles& before, const LiquidBodies& bodies_before,
                       const Triangles& after, const LiquidBodies& bodies_after);

}  // namespace suture::sims
