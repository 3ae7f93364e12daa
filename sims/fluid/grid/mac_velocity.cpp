// Velocity on the staggered grid: each component in the middle of the faces across its axis.
#include "sims/fluid/grid/mac_velocity.h"

#include <algorithm>
#include <cmath>

#include "kernel/lists.h"

namespace suture::sims {
namespace {

GridCorners corners(const SparseGrid& grid, int axis, const Point& p) {
  std::array<double, 3> within{0.5, 0.5, 0.5};
  within[axis] = 0;
  return {grid, within, p};
}

}  // namespace

double MacVelocity::component(int axis, const Point& p, double fallback) const {
  return corners(*grid, axis, p).value(u[axis], known[axis], fallback);
}

Point MacVelocity::at(const Point& p, const Point& fallback) const {
  return {component(0, p, fallback[0]), component(1, p, fallback[1]), component(2, p, fallback[2])};
}

MacVelocity::Bounds MacVelocity::bounds(int axis, const Point& p) const {
  return corners(*grid, axis, p).bounds(u[axis], known[axis]);
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
      sort_unique(front);
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

}  // namespace suture::sims
