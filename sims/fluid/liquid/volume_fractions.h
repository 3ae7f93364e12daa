// How much of each control volume of the staggered grid is liquid.
#pragma once

#include <array>
#include <vector>

#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {

/// Volume fractions of liquid, 0 to 1, of boxes of side h: cells, and those round the middles of
/// faces and of edges. All are made of the same eighths of cells, so that where one of them has
/// liquid, so have all that the strain rate there is weighed against [Batty and Bridson 2008, §4].
struct VolumeFractions {
  SharedGrid grid;
  std::vector<float> cell;
  std::array<std::vector<float>, 3> face;  ///< by axis: round the cell's low face across it
  std::array<std::vector<float>, 3> edge;  ///< by axis: round the edge along it from the low corner

  std::size_t memory() const;
};

/// An eighth with less than this is taken to be empty: such splinters would add next to nothing but
/// equations that are hard to solve.
inline constexpr float kLeastFraction = 1e-4f;

/// An eighth's fraction is what a plane cuts off it, that which D, trilinear between cell centres,
/// has at the eighth's middle: exact for a flat surface, symmetric, second order for a curved one.
VolumeFractions volume_fractions(const Liquid& liquid);

}  // namespace suture::sims
