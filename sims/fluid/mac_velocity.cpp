// Velocity on the staggered grid: each component in the middle of the faces across its axis.
#include "sims/fluid/mac_velocity.h"

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

/// The eight faces round a point and its place between them.
struct Corners {
  std::array<Slot, 8> slots;  ///< bit 2, 1, 0 of the index: high along x, y, z
  std::array<double, 3> between;
};

Corners corners(const SparseGrid& grid, int axis, const Point& p) {
  constexpr double far = 1 << 29;
  Corners c;
  Index3 low;
  for (int a = 0; a < 3; ++a) {
    const double x =
        std::clamp((p[a] - grid.origin()[a]) / grid.h() - (a == axis ? 0 : 0.5), -far, far);
    int whole =
        static_cast<int>(x);  // std::floor is a call, and this is where advection's time goes
    if (x < whole) --whole;
    low[a] = whole;
    c.between[a] = x - whole;
  }
  const Slot first = grid.find(low);
  const int side = SparseGrid::kSide;
  Index3 in{};
  if (first != kNoSlot) {
    const auto rest = static_cast<int>(first % SparseGrid::kCells);
    in = {rest / 64, rest / 8 % 8, rest % 8};
  }
  const bool one_block =
      first != kNoSlot && in[0] < side - 1 && in[1] < side - 1 && in[2] < side - 1;
  for (int n = 0; n < 8; ++n) {
    const int x = n >> 2 & 1, y = n >> 1 & 1, z = n & 1;
    c.slots[n] = one_block ? first + static_cast<Slot>(64 * x + 8 * y + z)
                           : grid.find({low[0] + x, low[1] + y, low[2] + z});
  }
  return c;
}

}  // namespace

double MacVelocity::component(int axis, const Point& p, double fallback) const {
  const Corners c = corners(*grid, axis, p);
  double sum = 0, weights = 0;
  for (int n = 0; n < 8; ++n) {
    const Slot s = c.slots[n];
    if (s == kNoSlot || known[axis][s] == 0) continue;
    double w = 1;
    for (int a = 0; a < 3; ++a) w *= (n >> (2 - a) & 1) != 0 ? c.between[a] : 1 - c.between[a];
    sum += w * u[axis][s];
    weights += w;
  }
  return weights > 1e-12 ? (weights == 1 ? sum : sum / weights) : fallback;
}

Point MacVelocity::at(const Point& p, const Point& fallback) const {
  return {component(0, p, fallback[0]), component(1, p, fallback[1]), component(2, p, fallback[2])};
}

MacVelocity::Bounds MacVelocity::bounds(int axis, const Point& p) const {
  Bounds b;
  for (const Slot s : corners(*grid, axis, p).slots) {
    if (s == kNoSlot || known[axis][s] == 0) continue;
    b.low = b.any ? std::min(b.low, u[axis][s]) : u[axis][s];
    b.high = b.any ? std::max(b.high, u[axis][s]) : u[axis][s];
    b.any = true;
  }
  return b;
}

void extrapolate(MacVelocity& velocity, int layers) {
  const SparseGrid& grid = *velocity.grid;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& u = velocity.u[axis];
    std::vector<std::uint8_t>& known = velocity.known[axis];
    std::vector<Slot> front;
    const auto add_unknown_neighbours = [&](Slot s, std::vector<Slot>& to) {
      for (int a = 0; a < 3; ++a)
        for (const int side : {-1, 1})
          if (const Slot n = grid.neighbour(s, a, side); n != kNoSlot && known[n] == 0)
            to.push_back(n);
    };
    for (Slot s = 0; s < grid.size(); ++s)
      if (known[s] != 0) add_unknown_neighbours(s, front);
    for (int layer = 0; layer < layers && !front.empty(); ++layer) {
      std::sort(front.begin(), front.end());
      front.erase(std::unique(front.begin(), front.end()), front.end());
      for (const Slot s : front) {
        double sum = 0;
        int count = 0;
        for (int a = 0; a < 3; ++a)
          for (const int side : {-1, 1})
            if (const Slot n = grid.neighbour(s, a, side); n != kNoSlot && known[n] != 0) {
              sum += u[n];
              ++count;
            }
        u[s] = sum / count;
      }
      for (const Slot s : front) known[s] = 1;
      std::vector<Slot> next;
      for (const Slot s : front) add_unknown_neighbours(s, next);
      front = std::move(next);
    }
  }
}

double largest_component(const MacVelocity& velocity) {
  double largest = 0;
  for (int a = 0; a < 3; ++a)
    for (Slot s = 0; s < velocity.u[a].size(); ++s)
      if (velocity.known[a][s] != 0) largest = std::max(largest, std::abs(velocity.u[a][s]));
  return largest;
}

}  // namespace suture
