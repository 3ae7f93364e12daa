// Signed distance to a closed surface: to the nearest triangle, with the sign of an exact winding.
#pragma once

#include "kernel/measure/nearest_triangle.h"
#include "kernel/triangles.h"

namespace suture {

/// One closed surface made ready for many questions. Any number of threads may ask.
///
/// The usual sign, that of the angle-weighted pseudonormal at the nearest point [Bærentzen and
/// Aanæs 2005], stands on normals, which slivers do not have, and is wrong wherever the nearest
/// sheet is one of two that coincide, or is buried in another body. What a ray crosses, counted by
/// exact orientations, is right for every closed surface; it takes 0.6 to 0.9 µs beside 1.3 µs for
/// the distance (25,000 triangles).
class SignedDistance {
 public:
  /// Keeps a copy. O(n log n). \pre the surface is closed and oriented, or windings mean nothing
  /// \throw InvalidInput as NearestTriangle
  explicit SignedDistance(Triangles surface) : nearest_(surface), surface_(std::move(surface)) {}

  /// Exact to rounding, at any scale; negative where winding(p) is at least 1, so in the union of
  /// bodies that overlap, where it is the distance to the nearest of their sheets, buried or not.
  /// \pre p is finite
  double at(const Point& p) const;

  /// How many times the surface goes round p, exact; anything where p is on it. \pre p is finite
  int winding(const Point& p) const;

  const NearestTriangle& nearest() const { return nearest_; }

 private:
  NearestTriangle nearest_;
  Triangles surface_;
};

}  // namespace suture
