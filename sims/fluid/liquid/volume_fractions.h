// How much of each control volume of the staggered grid is liquid.
#pragma once

#include <array>
#include <vector>

#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {

/// Liquid shares, 0 to 1, of boxes of side h: cells, and those round the middles of faces and of
/// edges. All are made of the same eighths of cells, so that where one of them has liquid, so have
/// all that the strain rate there is weighed against [Batty and Bridson 2008, §4].
struct Shares {
  const SparseGrid* grid = nullptr;
  std::vector<float> cell;
  std::array<std::vector<float>, 3> face;  ///< by axis: round the cell's low face across it
  std::array<std::vector<float>, 3> edge;  ///< by axis: round the edge along it from the low corner

  std::size_t memory() const;
};

/// Less than this of an eighth is none: such splinters would add next to nothing but equations that
/// are hard to solve.
inline constexpr float kLeastShare = 1e-4f;

/// An eighth's share is what a plane cuts off it, that which D, trilinear between cell centres, has
/// at the eighth's middle: exact for a flat surface, symmetric, second order for a curved one.
Shares liquid_shares(const Liquid& liquid);

}  // namespace suture::sims
