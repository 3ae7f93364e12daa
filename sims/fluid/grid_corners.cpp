// The eight places of a staggered quantity round a point, and what is interpolated from them.
#include "sims/fluid/grid_corners.h"

#include <algorithm>
#include <cmath>

namespace suture {

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
  const Slot first = grid.find(low);
  const int side = SparseGrid::kSide;
  Index3 in{};
  if (first != kNoSlot) in = SparseGrid::in_block(first);
  const bool one_block =
      first != kNoSlot && in[0] < side - 1 && in[1] < side - 1 && in[2] < side - 1;
  for (int n = 0; n < 8; ++n) {
    const int x = n >> 2 & 1, y = n >> 1 & 1, z = n & 1;
    slots[n] = one_block ? first + static_cast<Slot>(64 * x + 8 * y + z)
                         : grid.find({low[0] + x, low[1] + y, low[2] + z});
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
  return weights > 1e-12 ? (weights == 1 ? sum : sum / weights) : fallback;
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

}  // namespace suture
