// Velocity carried by itself from one grid to the next.
#pragma once

#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {

enum class VelocityAdvection {
  semi_lagrangian,  ///< first order; paths by the third-order rule of Ralston [Bridson 2015, §3]
  mac_cormack       ///< second order where it is smooth, clamped to what is round the path's start
                    ///< [Selle et al. 2008]
};

inline constexpr double kCarried = 1.5;  ///< cells; what MacCormack's way back looks at

/// Calls visit(axis, slot) with the faces that one of the two cells beside needs.
template <class Visit>
void for_each_carried_face(const Liquid& liquid, Visit visit) {
  const SparseGrid& grid = *liquid.grid;
  const double reach = kCarried * grid.h();
  for (Slot s = 0; s < grid.size(); ++s)
    for (int axis = 0; axis < 3; ++axis) {
      const Slot low = grid.neighbour(s, axis, -1);
      if (liquid.distance[s] < reach || (low != kNoSlot && liquid.distance[low] < reach))
        visit(axis, s);
    }
}

/// u(x, t + dt) = u(path back from x, t) on the faces of `grid` with a cell within `kCarried` cells
/// of the liquid; the rest is unknown. Paths may be many cells long. \pre `old` is known wherever
/// these begin, and `grid` has the old one's origin and cell size
MacVelocity carried(const MacVelocity& old, const Liquid& liquid, double dt,
                    VelocityAdvection scheme);

/// The starting point of the path through u that ends at p after dt. With dt < 0 the path goes on
/// from p instead.
Point path_start(const MacVelocity& u, const Point& p, double dt);

}  // namespace suture::sims
