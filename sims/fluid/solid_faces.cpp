// What solids leave open of the faces of the physics grid.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sims/fluid/solids.h"

namespace suture {
namespace {

constexpr int kSide = SparseGrid::kSide;
constexpr int kNodes = kSide + 1;

/// How many roundings of the coordinates a distance may be off.
constexpr double kRoundings = 16;

/// The area of the part of a unit square where values, linear along its sides, have this sign: the
/// corners in turn; that part joined across the middle where it has two opposite corners.
double part(const std::array<double, 4>& d, bool positive) {
  constexpr std::array<std::array<double, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<std::array<double, 2>, 8> outline;
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    if ((d[i] > 0) == positive) outline[size++] = corner[i];
    if ((d[i] > 0) == (d[j] > 0)) continue;
    const double s = d[i] / (d[i] - d[j]);
    outline[size++] = {corner[i][0] + s * (corner[j][0] - corner[i][0]),
                       corner[i][1] + s * (corner[j][1] - corner[i][1])};
  }
  double twice = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const auto &a = outline[i], &b = outline[(i + 1) % size];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return std::clamp(twice / 2, 0.0, 1.0);
}

double open_share(const std::array<double, 4>& d) {
  const auto solid = std::count_if(d.begin(), d.end(), [](double x) { return x <= 0; });
  if (solid == 0) return 1;
  if (solid == 4) return 0;
  const bool opposite = (d[0] > 0) == (d[2] > 0) && (d[1] > 0) == (d[3] > 0);
  const bool joined = d[0] + d[1] + d[2] + d[3] > 0;
  const double share = opposite && !joined ? 1 - part(d, false) : part(d, true);
  return share < kLeastOpen ? 0 : share;
}

/// The distances at the corners of a block's cells.
class Nodes {
 public:
  /// Whether a solid is in the block, or close to it.
  bool fill(const Solids& solids, const SparseGrid& grid, const Index3& low, double t) {
    const double h = grid.h();
    const Point first = grid.origin() + h * Point(low[0], low[1], low[2]);
    const Point middle = first + Point::Constant(h * kSide / 2);
    const double reach = std::sqrt(3.0) / 2 * kSide * h;
    if (solids.distance(middle, t) > reach) return false;
    double far = h;
    for (int a = 0; a < 3; ++a)
      far = std::max({far, std::abs(first[a]), std::abs(grid.origin()[a])});
    const double rounding = kRoundings * std::numeric_limits<double>::epsilon() * far;
    double least = std::numeric_limits<double>::infinity();
    for (int x = 0, n = 0; x < kNodes; ++x)
      for (int y = 0; y < kNodes; ++y)
        for (int z = 0; z < kNodes; ++z, ++n) {
          const Point p = grid.origin() + h * Point(low[0] + x, low[1] + y, low[2] + z);
          const double d = solids.distance(p, t);
          at_[n] = std::abs(d) <= rounding ? 0 : d;
          least = std::min(least, at_[n]);
        }
    return least <= 0;
  }

  /// Of the face across `axis` on the low side of a cell in the block.
  double open(const Index3& in, int axis) const {
    const int b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
    std::array<double, 4> d;
    for (int corner = 0; corner < 4; ++corner) {
      Index3 n = in;
      if (corner == 1 || corner == 2) ++n[b];
      if (corner >= 2) ++n[c];
      d[corner] = at_[(n[0] * kNodes + n[1]) * kNodes + n[2]];
    }
    return open_share(d);
  }

 private:
  std::array<double, kNodes * kNodes * kNodes> at_;
};

}  // namespace

SolidFaces faces_of(const Solids& solids, const SparseGrid& grid, double t) {
  SolidFaces faces;
  if (!solids.any()) return faces;
  for (int a = 0; a < 3; ++a) {
    faces.open[a].assign(grid.size(), 1);
    faces.velocity[a].assign(grid.size(), 0);
  }
  const bool moving = solids.fastest() > 0;
  Nodes nodes;
  for (std::size_t b = 0; b < grid.blocks().size(); ++b) {
    if (!nodes.fill(solids, grid, grid.blocks()[b], t)) continue;
    for (Slot s = b * SparseGrid::kCells; s < (b + 1) * SparseGrid::kCells; ++s) {
      const auto rest = static_cast<int>(s % SparseGrid::kCells);
      const Index3 in{rest / 64, rest / 8 % 8, rest % 8};
      for (int a = 0; a < 3; ++a) {
        faces.open[a][s] = nodes.open(in, a);
        if (moving && faces.open[a][s] < 1)
          faces.velocity[a][s] = solids.velocity(grid.face(grid.cell(s), a), t)[a];
      }
    }
  }
  return faces;
}

}  // namespace suture
