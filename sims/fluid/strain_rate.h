// The strain rate of a staggered velocity: which faces make each of its numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sims/fluid/mac_velocity.h"
#include "sims/fluid/shares.h"
#include "sims/fluid/solids.h"

namespace suture {

/// A symmetric tensor, each component where the strain rate of a staggered velocity is central:
/// stretch[a] is component (a,a) at cell centres, shear[a] is component (b,c), of the other two
/// axes, in the middle of the edge along a from the cell's low corner.
struct TensorField {
  std::array<std::vector<double>, 3> stretch, shear;

  bool any() const { return !stretch[0].empty(); }
  void resize(std::size_t slots);
  std::size_t memory() const;
};

/// One number as a sum over faces of coefficient·velocity.
struct RateStencil {
  int faces = 0;  ///< 0: there is no stress here
  std::array<int, 4> axis;
  std::array<Slot, 4> slot;
  std::array<double, 4> coefficient;
  double weight = 0;  ///< share of the control volume that it stands for

  double of(const MacVelocity& velocity) const;
};

/// The numbers of the strain rate that the liquid's stress is made of: those of control volumes
/// that have liquid. Without slip, faces whose middle is in a solid are held at its velocity, and
/// the shear beside them is over the way from the wall, as far as `open` tells it: exact for a wall
/// along the grid. With slip, solids exert no stress: what touches a closed face is left out.
class StrainRate {
 public:
  StrainRate(const Shares& shares, const SolidFaces& solids, bool no_slip)
      : shares_(&shares), solids_(&solids), no_slip_(no_slip) {}

  const SparseGrid& grid() const { return *shares_->grid; }
  /// The face is in a solid and moves with it.
  bool held(int axis, Slot s) const {
    return solids_->any() &&
           (no_slip_ ? solids_->open[axis][s] < 0.5 : !(solids_->open[axis][s] > 0));
  }
  double held_velocity(int axis, Slot s) const { return solids_->velocity_at(axis, s); }
  /// Of the face's control volume, what is liquid and not solid.
  double share(int axis, Slot s) const {
    return shares_->face[axis][s] * solids_->open_at(axis, s);
  }

  RateStencil stretch(int axis, Slot s) const;  ///< h·D_aa
  RateStencil shear(int axis, Slot s) const;    ///< 2h·D_bc

 private:
  double way_from_wall(int axis, Slot one, Slot other) const;

  const Shares* shares_;
  const SolidFaces* solids_;
  bool no_slip_;
};

}  // namespace suture
