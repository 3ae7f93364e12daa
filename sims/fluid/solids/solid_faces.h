// What solids leave open of the faces of the physics grid, and how they move there.
#pragma once

#include <array>
#include <vector>

#include "sims/fluid/solids/solids.h"

namespace suture::sims {

/// Empty arrays: the scene has no solids.
struct SolidFaces {
  std::array<std::vector<double>, 3> open;      ///< the open fraction, 0 to 1, of face (axis, slot)
  std::array<std::vector<double>, 3> velocity;  ///< the solid's component there

  bool any() const { return !open[0].empty(); }
  double open_at(int axis, Slot s) const { return any() ? open[axis][s] : 1; }
  double velocity_at(int axis, Slot s) const { return any() ? velocity[axis][s] : 0; }
  std::size_t memory() const;
};

/// A face that is open less than this is closed: a cell that only such faces join to the others
/// would have a row so small that the solver's tolerance says nothing about its velocities.
inline constexpr double kLeastOpen = 0.01;

/// Measures by the distances at a face's corners and middle, linear in between [Batty et al. 2007,
/// §4]. What is within rounding of a solid is in it: a wall on a plane of the grid closes what is
/// on it.
SolidFaces faces_of(const Solids& solids, const SparseGrid& grid, double t);

}  // namespace suture::sims
