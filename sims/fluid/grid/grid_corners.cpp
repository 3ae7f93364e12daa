// The eight places of a staggered quantity round a point, and what is interpolated from them.
#include "sims/fluid/grid/grid_corners.h"

#include <algorithm>
#include <cmath>

namespace suture::sims {
namespace {

/// Known faces that weigh less, of 1, do so by rounding alone: p is where none is known, and a
/// quotient of two such sums would be noise.
constexpr double kLeastWeight = 1e-12;

}  // namespace

GridCorners::GridCorners(const SparseGrid& grid, const std::array<double, 3>& within,
                         const Point& p) {
  constexpr double far = SparseGrid::kFurthest;
  Index3 low;
  for (int a = 0; a < 3; ++a) {
    const double x = std::clamp((p[a] - grid.origin()[a]) / grid.h() - within[a], -far, far);
    int whole = static_cast<int>(x);  // std::floor is a call, and advection's time goes here
    if (x < whole) --whole;
    low[a] = whole;
    between[a] = x - whole;
  }
  slots[0] = grid.find(low);
  const bool one_block =
      slots[0] != kNoSlot && (low[0] & 7) < 7 && (low[1] & 7) < 7 && (low[2] & 7) < 7;
  if (one_block) {
    for (Slot n = 1; n < 8; ++n) slots[n] = slots[0] + 64 * (n >> 2) + 8 * (n >> 1 & 1) + (n & 1);
    return;
  }
  for (int n = 1; n < 8; ++n) {  // each from the one below it along the last axis that it is up on
    const int axis = (n & 1) != 0 ? 2 : (n & 2) != 0 ? 1 : 0;
    const Slot below = slots[n & (n - 1)];
    slots[n] = below != kNoSlot
                   ? grid.neighbour(below, axis, 1)
                   : grid.find({low[0] + (n >> 2 & 1), low[1] + (n >> 1 & 1), low[2] + (n & 1)});
  }
}

double GridCorners::value(const std::vector<double>& values, const std::vector<std::uint8_t>& known,
                          double fallback) const {
  double sum = 0, weights = 0;
  for (int n = 0; n < 8; ++n) {
    const Slot s = slots[n];
    if (s == kNoSlot || known[s] == 0) continue;
    const double w = weight(n);
    sum += w * values[s];
    weights += w;
  }
  return weights > kLeastWeight ? (weights == 1 ? sum : sum / weights) : fallback;
}

GridCorners::Bounds GridCorners::bounds(const std::vector<double>& values,
                                        const std::vector<std::uint8_t>& known) const {
  Bounds b;
  for (const Slot s : slots) {
    if (s == kNoSlot || known[s] == 0) continue;
    b.low = b.any ? std::min(b.low, values[s]) : values[s];
    b.high = b.any ? std::max(b.high, values[s]) : values[s];
    b.any = true;
  }
  return b;
}

}  // namespace suture::sims
