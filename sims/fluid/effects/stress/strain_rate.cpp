// The strain rate of a staggered velocity: which faces make each of its numbers.
#include "sims/fluid/effects/stress/strain_rate.h"

#include <algorithm>

namespace suture::sims {
namespace {

/// A wall nearer than this to a face's middle, in cells, is as if it were so far: the stress of a
/// nearer one would make the face's equation a held one anyway.
constexpr double kNearestWall = 1e-3;

/// A wall along the grid leaves the faces across it as open on one side of a cell as on the other,
/// to the rounding of a solid's distance.
constexpr double kFlat = 1e-6;

}  // namespace

FewSlots edges_of_cell(const SparseGrid& grid, int axis, Slot s) {
  FewSlots edges;
  for (const Slot low : {s, grid.neighbour(s, next_axis(axis), 1)}) {
    if (low == kNoSlot) continue;
    edges.add(low);
    edges.add(grid.neighbour(low, prev_axis(axis), 1));
  }
  return edges;
}

FewSlots cells_round_edge(const SparseGrid& grid, int axis, Slot s) {
  FewSlots cells;
  for (const Slot high : {s, grid.neighbour(s, next_axis(axis), -1)}) {
    if (high == kNoSlot) continue;
    cells.add(high);
    cells.add(grid.neighbour(high, prev_axis(axis), -1));
  }
  return cells;
}

void TensorField::fill(std::size_t slots, double value) {
  for (int c = 0; c < 6; ++c) part(c).assign(slots, value);
}

std::size_t TensorField::memory() const {
  std::size_t n = 0;
  for (int a = 0; a < 3; ++a) n += stretch[a].capacity() + shear[a].capacity();
  return n * sizeof(double);
}

double StrainRate::value(const RateStencil& r, const MacVelocity& velocity) const {
  double sum = 0;
  for (int n = 0; n < r.faces; ++n)
    sum += r.coefficient[n] * velocity_at(velocity, r.axis[n], r.slot[n]);
  return sum;
}

RateStencil StrainRate::stretch(int axis, Slot s) const {
  RateStencil r;
  const Slot next = grid().neighbour(s, axis, 1);
  double weight = fractions_->cell[s];
  if (weight == 0 || next == kNoSlot) return r;
  double way = 1;
  if (solids_->any() && held(axis, s) != held(axis, next)) {
    way = way_across(axis, s);
    if (way == 0) return r;
  } else if (!no_slip_ && solids_->any()) {
    if (held(axis, s)) return r;
    weight *= (solids_->open[axis][s] + solids_->open[axis][next]) / 2;
  }
  r = {2, {axis, axis}, {s, next}, {-1 / way, 1 / way}, weight};
  r.weight = way * wetted(r);
  return r.weight > 0 ? r : RateStencil{};
}

double StrainRate::way_across(int axis, Slot s) const {
  double sum = 0, least = 1, most = 0;
  int count = 0;
  for (const int other : {next_axis(axis), prev_axis(axis)}) {
    const Slot high = grid().neighbour(s, other, 1);
    for (const double open :
         {solids_->open[other][s], high == kNoSlot ? 1 : solids_->open[other][high]}) {
      if (!no_slip_ && !(open > 0)) continue;  // another wall's
      sum += open;
      ++count;
      least = std::min(least, open);
      most = std::max(most, open);
    }
  }
  if (count == 0) return 1;
  if (!no_slip_ && most - least > kFlat) return 0;
  return std::clamp(sum / count, kNearestWall, 1.0);
}

/// The weight, but no more than there is liquid at the faces that are held: what has come within a
/// cell of a wall and not to it yet would stick to it already.
double StrainRate::wetted(const RateStencil& r) const {
  double weight = r.weight;
  for (int n = 0; n < r.faces; ++n)
    if (held(r.axis[n], r.slot[n]))
      weight = std::min<double>(weight, fractions_->face[r.axis[n]][r.slot[n]]);
  return weight;
}

/// The way, in cells, from the wall to the middle of that of two neighbouring faces which is not
/// held; 1 where there is no wall between.
double StrainRate::way_from_wall(int axis, Slot one, Slot other) const {
  if (held(axis, one) == held(axis, other)) return 1;
  const double open = solids_->open[axis][one] + solids_->open[axis][other];
  return std::clamp(open - 0.5, kNearestWall, 1.0);
}

RateStencil StrainRate::shear(int axis, Slot s) const {
  RateStencil r;
  const int b = next_axis(axis), c = prev_axis(axis);
  const Slot below_b = grid().neighbour(s, b, -1), below_c = grid().neighbour(s, c, -1);
  r.weight = fractions_->edge[axis][s];
  if (r.weight == 0 || below_b == kNoSlot || below_c == kNoSlot) return RateStencil{};
  r.faces = 4;
  r.axis = {b, b, c, c};
  r.slot = {s, below_c, s, below_b};
  r.coefficient = {1, -1, 1, -1};
  if (solids_->any() && no_slip_) {
    const double way_b = way_from_wall(b, s, below_c), way_c = way_from_wall(c, s, below_b);
    r.coefficient = {1 / way_b, -1 / way_b, 1 / way_c, -1 / way_c};
    r.weight = std::min(way_b, way_c) * wetted(r);
  } else if (solids_->any()) {
    double open = 0;
    for (int n = 0; n < 4; ++n) {
      if (held(r.axis[n], r.slot[n])) return RateStencil{};
      open += solids_->open[r.axis[n]][r.slot[n]];
    }
    r.weight *= open / 4;
  }
  return r.weight > 0 ? r : RateStencil{};
}

}  // namespace suture::sims
