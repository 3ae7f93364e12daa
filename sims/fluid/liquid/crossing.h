// Where the surface passes between the centres of neighbouring cells, one after another.
#pragma once

#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {

/// Calls f(axis, face, cell, point) for each face between a cell inside and one outside: `cell` is
/// the one inside, `point` where the surface leaves on the way from its centre to the other's.
template <class F>
void for_each_crossing(const Liquid& liquid, F f) {
  const SparseGrid& grid = *liquid.grid;
  for (int axis = 0; axis < 3; ++axis)
    for (Slot s = 0; s < grid.size(); ++s) {
      const Slot below = grid.neighbour(s, axis, -1);
      if (below == kNoSlot || liquid.inside(s) == liquid.inside(below)) continue;
      const bool up = liquid.inside(below);
      const Slot cell = up ? below : s;
      Point at = grid.centre(grid.cell(cell));
      at[axis] += (up ? 1 : -1) * grid.h() * liquid.share(axis, s);
      f(axis, s, cell, at);
    }
}

}  // namespace suture::sims
