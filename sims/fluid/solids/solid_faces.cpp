// What solids leave open of the faces of the physics grid, and how they move there.
#include "sims/fluid/solids/solid_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace suture::sims {
namespace {

constexpr int kSide = SparseGrid::kSide;
constexpr int kNodes = kSide + 1;

/// How many roundings of the coordinates a distance may be off.
constexpr double kRoundings = 16;

/// The part of a triangle where a value that is linear on it is above 0.
double open_part(double a, double b, double c) {
  const int open = (a > 0 ? 1 : 0) + (b > 0 ? 1 : 0) + (c > 0 ? 1 : 0);
  if (open == 0 || open == 3) return open == 3 ? 1 : 0;
  // The corner that is alone on its side.
  const bool alone = open == 1;
  if ((b > 0) == alone)
    std::swap(a, b);
  else if ((c > 0) == alone)
    std::swap(a, c);
  const double cut = a / (a - b) * (a / (a - c));
  return alone ? cut : 1 - cut;
}

/// The open part of a face, from its corners in turn and its middle: of the four triangles round
/// the middle. With the corners alone a face in the corner of two walls, of which three corners are
/// on them, is half open.
double open_fraction(const std::array<double, 4>& d, double middle) {
  double fraction = 0;
  for (int n = 0; n < 4; ++n) fraction += open_part(d[n], d[(n + 1) % 4], middle) / 4;
  return fraction < kLeastOpen ? 0 : fraction;
}

/// The distances at the corners of a block's cells.
class Nodes {
 public:
  Nodes(const Solids& solids, const SparseGrid& grid, double t)
      : solids_(solids), grid_(grid), t_(t) {}

  /// Whether a solid is in the block, or close to it.
  bool fill(const Index3& low) {
    const double h = grid_.h();
    const Point first = grid_.origin() + h * Point(low[0], low[1], low[2]);
    const double reach = std::sqrt(3.0) / 2 * kSide * h;
    if (solids_.distance(first + Point::Constant(h * kSide / 2), t_) > reach) return false;
    double far = h;
    for (int a = 0; a < 3; ++a)
      far = std::max({far, std::abs(first[a]), std::abs(grid_.origin()[a])});
    rounding_ = kRoundings * std::numeric_limits<double>::epsilon() * far;
    double least = std::numeric_limits<double>::infinity();
    for (int x = 0, n = 0; x < kNodes; ++x)
      for (int y = 0; y < kNodes; ++y)
        for (int z = 0; z < kNodes; ++z, ++n) {
          at_[n] = distance(grid_.origin() + h * Point(low[0] + x, low[1] + y, low[2] + z));
          least = std::min(least, at_[n]);
        }
    return least <= 0;
  }

  /// The open fraction of the face across `axis` on the low side of a cell, whose place in the
  /// block is `in`.
  double open(const Index3& in, int axis, Slot s) const {
    const int b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
    std::array<double, 4> d;
    for (int corner = 0; corner < 4; ++corner) {
      Index3 n = in;
      if (corner == 1 || corner == 2) ++n[b];
      if (corner >= 2) ++n[c];
      d[corner] = at_[(n[0] * kNodes + n[1]) * kNodes + n[2]];
    }
    const auto [least, most] = std::minmax_element(d.begin(), d.end());
    if (*least > 0) return 1;
    if (*most < 0) return 0;
    return open_fraction(d, distance(grid_.face(grid_.cell(s), axis)));
  }

 private:
  double distance(const Point& p) const {
    const double d = solids_.distance(p, t_);
    return std::abs(d) <= rounding_ ? 0 : d;
  }

  const Solids& solids_;
  const SparseGrid& grid_;
  double t_, rounding_ = 0;
  std::array<double, kNodes * kNodes * kNodes> at_;
};

}  // namespace

std::size_t SolidFaces::memory() const {
  std::size_t bytes = 0;
  for (int a = 0; a < 3; ++a) bytes += (open[a].size() + velocity[a].size()) * sizeof(double);
  return bytes;
}

SolidFaces faces_of(const Solids& solids, const SparseGrid& grid, double t) {
  SolidFaces faces;
  if (!solids.any()) return faces;
  for (int a = 0; a < 3; ++a) {
    faces.open[a].assign(grid.size(), 1);
    faces.velocity[a].assign(grid.size(), 0);
  }
  const bool moving = solids.fastest() > 0;
  Nodes nodes(solids, grid, t);
  for (std::size_t b = 0; b < grid.blocks().size(); ++b) {
    if (!nodes.fill(grid.blocks()[b])) continue;
    for (Slot s = b * SparseGrid::kCells; s < (b + 1) * SparseGrid::kCells; ++s) {
      const Index3 in = SparseGrid::in_block(s);
      for (int a = 0; a < 3; ++a) {
        faces.open[a][s] = nodes.open(in, a, s);
        if (moving && faces.open[a][s] < 1)
          faces.velocity[a][s] = solids.velocity(grid.face(grid.cell(s), a), t)[a];
      }
    }
  }
  return faces;
}

}  // namespace suture::sims
