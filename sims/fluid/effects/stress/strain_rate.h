// The strain rate of a staggered velocity: which faces make each of its numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/liquid/volume_fractions.h"

namespace suture::sims {

/// A symmetric tensor, each component where the strain rate of a staggered velocity is central:
/// stretch[a] is component (a,a) at cell centres, shear[a] is component (b,c), of the other two
/// axes, in the middle of the edge along a from the cell's low corner.
struct TensorField {
  std::array<std::vector<double>, 3> stretch, shear;

  bool any() const { return !stretch[0].empty(); }
  std::vector<double>& part(int component) {  ///< 0 to 2: stretch; 3 to 5: shear
    return component < 3 ? stretch[component] : shear[component - 3];
  }
  const std::vector<double>& part(int component) const {
    return component < 3 ? stretch[component] : shear[component - 3];
  }
  void fill(std::size_t slots, double value);
  std::size_t memory() const;
};

/// Up to four slots, to loop over.
class FewSlots {
 public:
  void add(Slot s) {
    if (s != kNoSlot) slots_[count_++] = s;
  }
  const Slot* begin() const { return slots_.data(); }
  const Slot* end() const { return slots_.data() + count_; }

 private:
  std::array<Slot, 4> slots_{};
  std::size_t count_ = 0;
};

/// The edges of cell s along `axis` that exist, as slots of the cells whose low corner they are at.
FewSlots edges_of_cell(const SparseGrid& grid, int axis, Slot s);

/// The cells that exist round the edge along `axis` from the low corner of cell s.
FewSlots cells_round_edge(const SparseGrid& grid, int axis, Slot s);

/// One number as a sum over faces of coefficient·velocity.
struct RateStencil {
  int faces = 0;  ///< 0: there is no stress here
  std::array<int, 4> axis;
  std::array<Slot, 4> slot;
  std::array<double, 4> coefficient;
  double weight = 0;  ///< fraction of the control volume that it stands for
};

/// Whether liquid may slip along solids.
enum class WallSlip { none, free };

/// The numbers of the strain rate that the liquid's stress is made of: those of control volumes
/// that have liquid. Without slip, faces whose middle is in a solid are held at its velocity, and
/// the shear beside them is over the way from the wall, as far as `open` tells it: exact for a wall
/// along the grid. With slip, only the stress across a wall along the grid is there, whose closed
/// faces no liquid crosses; else what touches a closed face, which may slip, is left out.
class StrainRate {
 public:
  /// Keeps references to both.
  StrainRate(const VolumeFractions& fractions, const SolidFaces& solids, WallSlip slip)
      : fractions_(&fractions), solids_(&solids), no_slip_(slip == WallSlip::none) {}

  const SharedGrid& shared_grid() const { return fractions_->grid; }
  const SparseGrid& grid() const { return *fractions_->grid; }
  /// The face is in a solid and moves with it.
  bool held(int axis, Slot s) const {
    return solids_->any() &&
           (no_slip_ ? solids_->open[axis][s] < 0.5 : !(solids_->open[axis][s] > 0));
  }
  /// The face's velocity: the solid's where it is held, and 0 where it is not known.
  double velocity_at(const MacVelocity& velocity, int axis, Slot s) const {
    return held(axis, s)                  ? solids_->velocity_at(axis, s)
           : velocity.known[axis][s] != 0 ? velocity.u[axis][s]
                                          : 0;
  }
  double value(const RateStencil& stencil, const MacVelocity& velocity) const;
  /// The part of the face's control volume that is liquid and not solid.
  double fraction(int axis, Slot s) const {
    return fractions_->face[axis][s] * solids_->open_at(axis, s);
  }

  /// Calls visit(stencil, component, slot) with all that there are, by slots.
  template <class Visit>
  void for_each(Visit visit) const {
    for (Slot s = 0; s < grid().size(); ++s)
      for (int a = 0; a < 3; ++a) {
        if (const RateStencil r = stretch(a, s); r.faces != 0) visit(r, a, s);
        if (const RateStencil r = shear(a, s); r.faces != 0) visit(r, a + 3, s);
      }
  }
  RateStencil stretch(int axis, Slot s) const;  ///< h·D_aa
  RateStencil shear(int axis, Slot s) const;    ///< 2h·D_bc

 private:
  /// The way in cell s, in cells, from the wall across `axis` to the face on the other side; 0
  /// where that is slipped along and not along the grid.
  double way_across(int axis, Slot s) const;
  double way_from_wall(int axis, Slot one, Slot other) const;
  double wetted(const RateStencil& r) const;

  const VolumeFractions* fractions_;
  const SolidFaces* solids_;
  bool no_slip_;
};

}  // namespace suture::sims
