// How much of each control volume of the staggered grid is liquid.
#include "sims/fluid/liquid/volume_fractions.h"

#include <cmath>

#include "sims/fluid/grid/cut_cube.h"

namespace suture::sims {
namespace {

/// D at the 27 cells round s; what does not exist is air.
std::array<double, 27> values_round(const Liquid& liquid, Slot s) {
  const SparseGrid& grid = *liquid.grid;
  const Index3 c = grid.cell(s);
  std::array<double, 27> d;
  for (int n = 0; n < 27; ++n) {
    const Slot at = grid.find({c[0] + n / 9 - 1, c[1] + n / 3 % 3 - 1, c[2] + n % 3 - 1});
    d[n] = at == kNoSlot ? kFar * grid.h() : liquid.distance[at];
  }
  return d;
}

/// An eighth of a cell, on these sides (0 low, 1 high) of its centre.
struct Eighth {
  Slot cell;
  Index3 side;
};

/// The liquid fraction of the eighth of a cell on these sides of its centre.
double fraction_of_eighth(const std::array<double, 27>& d, const Index3& side) {
  double value = 0;
  Point slope = Point::Zero();  // over an eighth's side
  for (int n = 0; n < 8; ++n) {
    const Index3 out{n >> 2 & 1, n >> 1 & 1, n & 1};  // from the centre towards the eighth
    double weight = 1;
    int at = 0;
    for (int a = 0; a < 3; ++a) {
      weight *= out[a] == 0 ? 0.75 : 0.25;
      at = 3 * at + 1 + (out[a] == 0 ? 0 : 2 * side[a] - 1);
    }
    value += weight * d[at];
    for (int a = 0; a < 3; ++a) {
      const double sign = (out[a] == 0 ? -1 : 1) * (2 * side[a] - 1);
      slope[a] += sign / 2 * weight / (out[a] == 0 ? 0.75 : 0.25) * d[at];
    }
  }
  const double most = slope.cwiseAbs().sum() / 2;  // of slope·x in the eighth
  return std::abs(value) < most ? cut_volume(slope, -value) : value < 0 ? 1 : 0;
}

/// Adds an eighth to the boxes that it is part of.
void add_eighth(VolumeFractions& to, const Eighth& eighth, float fraction) {
  const SparseGrid& grid = *to.grid;
  const auto& [s, side] = eighth;
  const auto add = [&](std::vector<float>& boxes, Slot at) {
    if (at != kNoSlot) boxes[at] += fraction / 8;
  };
  add(to.cell, s);
  std::array<Slot, 3> next;  // the slot whose low face across the axis bounds the eighth
  for (int a = 0; a < 3; ++a) {
    next[a] = side[a] == 0 ? s : grid.neighbour(s, a, 1);
    add(to.face[a], next[a]);
  }
  for (int a = 0; a < 3; ++a) {
    const int b = next_axis(a), c = prev_axis(a);
    add(to.edge[a], side[c] == 0 || next[b] == kNoSlot ? next[b] : grid.neighbour(next[b], c, 1));
  }
}

}  // namespace

std::size_t VolumeFractions::memory() const {
  std::size_t n = cell.capacity();
  for (int a = 0; a < 3; ++a) n += face[a].capacity() + edge[a].capacity();
  return n * sizeof(float);
}

VolumeFractions volume_fractions(const Liquid& liquid) {
  const SparseGrid& grid = *liquid.grid;
  VolumeFractions fractions;
  fractions.grid = liquid.grid;
  fractions.cell.assign(grid.size(), 0);
  for (int a = 0; a < 3; ++a) {
    fractions.face[a].assign(grid.size(), 0);
    fractions.edge[a].assign(grid.size(), 0);
  }
  for (Slot s = 0; s < grid.size(); ++s) {
    const double own = liquid.distance[s];
    const bool near = std::abs(own) < kNear * grid.h();  // further than any of the 27
    if (!near && own > 0) continue;
    std::array<double, 27> d{};
    if (near) d = values_round(liquid, s);
    for (int n = 0; n < 8; ++n) {
      const Index3 side{n >> 2 & 1, n >> 1 & 1, n & 1};
      const auto fraction = near ? static_cast<float>(fraction_of_eighth(d, side)) : 1.0f;
      if (fraction >= kLeastFraction) add_eighth(fractions, {s, side}, fraction);
    }
  }
  return fractions;
}

}  // namespace suture::sims
