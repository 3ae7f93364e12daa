// The eight places of a staggered quantity round a point, and what is interpolated from them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sims/fluid/grid/sparse_grid.h"

namespace suture::sims {

/// The corners for a quantity that each cell has at one place, `within` cells up each axis from its
/// low corner.
struct GridCorners {
  std::array<Slot, 8> slots;      ///< bit 2, 1, 0 of the index: high along x, y, z
  std::array<double, 3> between;  ///< the point's place between them

  GridCorners(const SparseGrid& grid, const std::array<double, 3>& within, const Point& p);

  /// The weight of slots[n] in a trilinear mean.
  double weight(int n) const {
    double w = 1;
    for (int a = 0; a < 3; ++a) w *= (n >> (2 - a) & 1) != 0 ? between[a] : 1 - between[a];
    return w;
  }

  /// Trilinear from the known ones; where some are not, from the others alone, and where none is,
  /// `fallback`.
  double value(const std::vector<double>& values, const std::vector<std::uint8_t>& known,
               double fallback) const;

  /// The least and largest of the known ones.
  struct Bounds {
    double low = 0, high = 0;
    bool any = false;
  };
  Bounds bounds(const std::vector<double>& values, const std::vector<std::uint8_t>& known) const;
};

}  // namespace suture::sims
