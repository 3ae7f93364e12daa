// The signed distance to a closed surface: to the nearest triangle, with the sign of its winding.
#pragma once

#include "kernel/measure/nearest_triangle.h"
#include "kernel/triangles.h"

namespace suture {

/// One closed surface made ready for many questions. Any number of threads may ask at once.
///
/// The usual sign is that of the angle-weighted pseudonormal at the nearest point [Bærentzen and
/// Aanæs 2005]. It stands on normals, which slivers do not have, and it is wrong where the nearest
/// sheet is one of two that coincide, or is buried in another body. Counting what a ray crosses, by
/// exact orientations, is right for every closed surface. It takes 0.6 to 0.9 µs, beside 1.3 µs for
/// the distance (25,000 triangles).
class SignedDistance {
 public:
  /// Keeps a copy of the surface. It takes O(n log n). \pre the surface is closed and oriented,
  /// else windings mean nothing \throw InvalidInput as NearestTriangle does
  explicit SignedDistance(Triangles surface) : nearest_(surface), surface_(std::move(surface)) {}

  /// The distance, exact to rounding at any scale, negative where winding(p) is at least 1. Within
  /// bodies that overlap it is the distance to the nearest of their sheets, buried or not.
  /// \pre p is finite
  double at(const Point& p) const;

  /// How many times the surface goes round p, exactly; where p is on it any number. \pre p is
  /// finite
  int winding(const Point& p) const;

  const NearestTriangle& nearest() const { return nearest_; }

 private:
  NearestTriangle nearest_;
  Triangles surface_;
};

}  // namespace suture
