// The rectilinear lattice: its planes are exactly these doubles, shifted symbolically [§5].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// Node (i,j,k), or the cell whose lowest corner is that node, or with an axis: the lattice edge
/// that leaves the node along the axis; the lattice face across the axis with the node as lowest
/// corner.
using Index3 = std::array<int, 3>;
using LatticeId = std::uint64_t;

inline constexpr int kIndexBits = 21;
inline constexpr int kMaxPlanes = (1 << kIndexBits) - 2;  ///< on each axis

constexpr LatticeId pack(int i, int j, int k) {
  return (static_cast<LatticeId>(i) << (2 * kIndexBits)) |
         (static_cast<LatticeId>(j) << kIndexBits) | static_cast<LatticeId>(k);
}
constexpr LatticeId pack(const Index3& i) { return pack(i[0], i[1], i[2]); }
constexpr Index3 unpack(LatticeId id) {
  constexpr LatticeId mask = (LatticeId{1} << kIndexBits) - 1;
  return {static_cast<int>(id >> (2 * kIndexBits)), static_cast<int>((id >> kIndexBits) & mask),
          static_cast<int>(id & mask)};
}
/// The id `steps` further along `axis`.
constexpr LatticeId step(LatticeId id, int axis, int steps) {
  return id + static_cast<LatticeId>(static_cast<std::int64_t>(steps) *
                                     (std::int64_t{1} << (kIndexBits * (2 - axis))));
}

inline constexpr const char* kAxisName[3] = {"x", "y", "z"};
constexpr int next_axis(int axis) { return axis == 2 ? 0 : axis + 1; }
constexpr int prev_axis(int axis) { return axis == 0 ? 2 : axis - 1; }

/// Calls visit(cell) with the four cells round the lattice edge along `axis`.
template <class Visit>
void cells_round_edge(LatticeId edge, int axis, Visit visit) {
  const int b = next_axis(axis), c = prev_axis(axis);
  visit(edge);
  visit(step(edge, b, -1));
  visit(step(edge, c, -1));
  visit(step(step(edge, b, -1), c, -1));
}

struct Box {
  Point low = Point::Constant(0), high = Point::Constant(0);
};
/// \pre surface has a vertex
Box bounding_box(const std::vector<Point>& positions);

/// Strictly increasing planes on each axis. Every decision sees plane p at p + ε (ε₁ ≫ ε₂ ≫ ε₃ >
/// 0), so a coordinate that equals a plane lies below it and belongs to exactly one cell.
class Lattice {
 public:
  /// \throw InvalidInput unless each list is finite, strictly increasing, and 2 to kMaxPlanes long
  explicit Lattice(std::array<std::vector<double>, 3> planes);

  double plane(int axis, int i) const { return planes_[axis][static_cast<std::size_t>(i)]; }
  int planes(int axis) const { return static_cast<int>(planes_[axis].size()); }
  int cells(int axis) const { return planes(axis) - 1; }
  Point node(const Index3& i) const { return {plane(0, i[0]), plane(1, i[1]), plane(2, i[2])}; }

  /// The cell i with plane(i) < x <= plane(i+1); -1 or cells(axis) outside the lattice.
  int cell_of(int axis, double x) const {
    const auto& p = planes_[axis];
    const double guess = (x - p.front()) * per_unit_[axis];
    const int last = static_cast<int>(p.size()) - 1;
    int i = guess > 0 ? (guess < last ? static_cast<int>(guess) : last) : 0;
    while (i > 0 && x <= p[static_cast<std::size_t>(i)]) --i;
    if (i == 0 && x <= p[0]) return -1;
    while (i < last && x > p[static_cast<std::size_t>(i) + 1]) ++i;
    return i;
  }
  Index3 cell_of(const Point& p) const {
    return {cell_of(0, p[0]), cell_of(1, p[1]), cell_of(2, p[2])};
  }

  bool operator==(const Lattice&) const = default;

 private:
  std::array<std::vector<double>, 3> planes_;
  std::array<double, 3> per_unit_;
};

/// Planes origin + i·cell_size (rounded once) that cover `box` with `margin` whole cells to spare.
/// \throw InvalidInput if cell_size is not finite and positive, is below the spacing of doubles
/// there, or asks for more than kMaxPlanes planes on an axis
Lattice lattice_around(const Box& box, double cell_size, const Point& origin = Point::Zero(),
                       int margin = 3);

}  // namespace suture
