// Monotone lattice paths: the order of cells along a mesh edge and along triangle ∩ plane [§5,
// §6.1].
#pragma once

#include <vector>

#include "kernel/lattice.h"
#include "predicates/oracle.h"

namespace suture::surgery {

/// A mesh edge with the cells that hold its ends.
struct LatticeSegment {
  Point p, q;
  Index3 p_cell, q_cell;
};

/// A step from cell to cell through the lattice face across `axis`.
struct FaceStep {
  LatticeId face;
  int axis;
};

/// Appends the faces that the segment passes, from p to q.
/// \throw InternalFailure where the oracle's answers fit no path (no exact oracle does that)
void edge_path(const LatticeSegment& segment, const Lattice& lattice, const Oracle& oracle,
               std::vector<FaceStep>& path);

/// A mesh triangle, and its normal in plain doubles: a guess, confirmed by the oracle.
struct LatticeTriangle {
  Point a, b, c;
  Point normal;
};
LatticeTriangle lattice_triangle(const Point& a, const Point& b, const Point& c);

/// A step from face to face of one plane through the lattice edge along `axis`; `normal` is the
/// sign of the triangle's normal along that axis.
struct LineStep {
  LatticeId edge;
  int axis;
  int normal;
};

/// Appends the lattice edges that triangle ∩ {plane from[axis] across `axis`} passes between two of
/// its faces: from where the triangle's boundary comes up through the plane to where it goes down.
/// \throw InternalFailure as edge_path
void plane_path(const LatticeTriangle& triangle, int axis, const Index3& from, const Index3& to,
                const Lattice& lattice, const Oracle& oracle, std::vector<LineStep>& path);

}  // namespace suture::surgery
