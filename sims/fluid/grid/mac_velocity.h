// Velocity on the staggered grid: each component in the middle of the faces across its axis.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sims/fluid/grid/grid_corners.h"

namespace suture::sims {

/// One component a face: u[a][s] is at grid->face(grid->cell(s), a), the low side of cell s. Faces
/// that are not known hold nothing that means anything.
struct MacVelocity {
  const SparseGrid* grid = nullptr;
  std::array<std::vector<double>, 3> u;
  std::array<std::vector<std::uint8_t>, 3> known;

  MacVelocity() = default;
  explicit MacVelocity(const SparseGrid& g) : grid(&g) {
    for (int a = 0; a < 3; ++a) {
      u[a].assign(g.size(), 0);
      known[a].assign(g.size(), 0);
    }
  }

  /// Component `axis` at p, trilinear from the known faces round it; where some are not, from the
  /// others alone, and where none is, `fallback`.
  double component(int axis, const Point& p, double fallback = 0) const;
  Point at(const Point& p, const Point& fallback = Point::Zero()) const;

  /// Component `axis` of the least and largest known face round p, for clamping.
  using Bounds = GridCorners::Bounds;
  Bounds bounds(int axis, const Point& p) const;
};

/// Gives the faces within `layers` faces of the known ones the mean of their known neighbours,
/// layer by layer [Bridson 2015, §4.1].
void extrapolate(MacVelocity& velocity, int layers);

/// The largest magnitude of a component on the known faces; 0 where there is none.
double largest_component(const MacVelocity& velocity);

}  // namespace suture::sims
