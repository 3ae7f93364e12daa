// The places where the lines of a regular grid along one axis cross triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"

namespace suture {

// Where the grid of each axis begins, in spacings. With these offsets no line runs along edges of a
// regular mesh, and no two axes see a symmetric body alike.
inline constexpr std::array<double, 3> kOffset1 = {0.38196601125010515, 0.7639320225002103,
                                                   0.14589803375},
                                       kOffset2 = {0.24512233375330728, 0.8301597090,
                                                   0.5698402909980};

/// A grid of lines along one axis: a line is a point of the plane of the other two.
struct LineGrid {
  int along, across1, across2;
  double low1, low2, spacing;
  std::int64_t count1, count2;

  double first(std::int64_t i) const {
    return low1 + (static_cast<double>(i) + kOffset1[along]) * spacing;
  }
  double second(std::int64_t j) const {
    return low2 + (static_cast<double>(j) + kOffset2[along]) * spacing;
  }
};

/// The lines along `axis` that the box holds. \pre spacing > 0
LineGrid grid_along(int axis, const Box& box, double spacing);

struct LineCut {
  std::int64_t line;
  double height;
  int surface, step;  ///< the winding of `surface` changes by `step` along the line
};

/// Cuts the lines of a grid by the triangles of one surface.
struct Cutter {
  const Triangles& s;
  const LineGrid& g;
  int surface;

  /// Adds the cuts of one triangle.
  void cut(const Triangle& t, std::vector<LineCut>& cuts) const;

 private:
  double side(std::array<std::uint32_t, 2> edge, double x, double y) const;
};

/// Sorts cuts by line and then along it, alike on every machine.
void sort_along(std::vector<LineCut>& cuts);

}  // namespace suture
