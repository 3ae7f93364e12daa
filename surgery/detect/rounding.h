// The rounding of new vertices, which may put a node that the surface all but meets on its other
// side.
#pragma once

#include "kernel/lattice.h"
#include "kernel/measure/nearest_triangle.h"

namespace suture::surgery {

/// How far from a surface surgery's rounding can change a node's winding. The arguments must
/// outlive it.
class Rounding {
 public:
  Rounding(const Triangles& surface, const Lattice& lattice);

  /// Whether the node is within rounding of the surface: within four times the diagonal of a box of
  /// units in the last place from a triangle. On each axis the unit is that of the largest
  /// coordinate of the triangle or of the cells round the node: in one of these all vertices lie
  /// that surgery can have put in there, each off by a unit at most [papers/proof.md, 9.4].
  bool reaches(const Index3& node) const;

 private:
  const Triangles& surface_;
  const Lattice& lattice_;
  NearestTriangle nearest_;
};

}  // namespace suture::surgery
