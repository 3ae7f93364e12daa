// Monotone lattice paths: the order of cells along a mesh edge and along triangle ∩ plane [§5,
// §6.1].
#pragma once

#include <vector>

#include "surgery/model/tracker_lattice.h"

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
void edge_path(const LatticeSegment& segment, const ShiftedLattice& on,
               std::vector<FaceStep>& path);

/// A mesh triangle, and its normal in plain doubles: a guess that the oracle confirms.
struct LatticeTriangle {
  Point a, b, c;
  Point normal;
};
LatticeTriangle lattice_triangle(const Point& a, const Point& b, const Point& c);

/// The chord in which a triangle meets the lattice plane {from[axis] across `axis`}: between two
/// faces of the plane, from where the triangle's boundary comes up through it to where it goes
/// down.
struct PlaneChord {
  const LatticeTriangle& triangle;
  int axis;
  Index3 from, to;
};

/// A step from face to face of one plane through the lattice edge along `axis`; `normal` is the
/// sign of the triangle's normal along that axis.
struct LineStep {
  LatticeId edge;
  int axis;
  int normal;
};

/// Appends the lattice edges that the chord passes, in its order. \throw InternalFailure as
/// edge_path
void plane_path(const PlaneChord& chord, const ShiftedLattice& on, std::vector<LineStep>& path);

}  // namespace suture::surgery
