// Velocity on the staggered grid: each component in the middle of the faces across its axis.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "sims/fluid/grid/grid_corners.h"

namespace suture::sims {

/// Each face has one component: u[a][s] is at grid->face(grid->cell(s), a), the low side of cell s.
/// A face that is not known holds a number without meaning.
struct MacVelocity {
  SharedGrid grid;
  std::array<std::vector<double>, 3> u;
  std::array<std::vector<std::uint8_t>, 3> known;

  MacVelocity() = default;
  /// \pre g is not null
  explicit MacVelocity(SharedGrid g) : grid(std::move(g)) {
    for (int a = 0; a < 3; ++a) {
      u[a].assign(grid->size(), 0);
      known[a].assign(grid->size(), 0);
    }
  }

  /// Component `axis` at p, trilinear from the known faces round it; where some are not, from the
  /// others alone, and where none is, `fallback`.
  double component(int axis, const Point& p, double fallback = 0) const;
  Point at(const Point& p, const Point& fallback = Point::Zero()) const;

  /// The least and largest known of the faces round p that hold component `axis`, for clamping.
  using Bounds = GridCorners::Bounds;
  Bounds bounds(int axis, const Point& p) const;
};

/// Gives the faces within `layers` faces of the known ones the mean of their known neighbours,
/// layer by layer [Bridson 2015, §4.1].
void extrapolate(MacVelocity& velocity, int layers);

/// The largest magnitude of a component on the known faces; 0 where there is none.
double largest_component(const MacVelocity& velocity);

}  // namespace suture::sims
