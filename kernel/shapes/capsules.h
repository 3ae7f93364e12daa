// A smooth union of tapered capsules, and its surface: what animals and hands are made of.
#pragma once

#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"

namespace suture {

/// Balls of radius `from` to `to` along a segment.
struct Capsule {
  Point start, end;
  double from = 0, to = 0;
};

/// Nearly the signed distance to capsules that flow into each other within `round`.
class CapsuleUnion {
 public:
  struct Value {
    double value = 0;
    Point gradient = Point::Zero();
  };

  /// \pre there is a capsule, none without length; round > 0
  CapsuleUnion(std::vector<Capsule> capsules, double round)
      : capsules_(std::move(capsules)), round_(round) {}

  Value at(const Point& p) const;
  /// By Newton's method from p, which is within half a cell of it.
  Point onto_surface(Point p) const;

 private:
  std::vector<Capsule> capsules_;
  double round_;
};

/// Where a union's surface is, and how large it is made.
struct SkinOptions {
  Box box;  ///< holds the surface, but for 0.06; in the union's own unit
  Point centre = Point::Zero();
  double length = 1;       ///< of the union's unit
  double edge_length = 0;  ///< as centre and length in the scene's unit
};

/// Its surface, closed and oriented, with edges of about edge_length, relaxed.
Triangles skin(const CapsuleUnion& capsules, const SkinOptions& options);

}  // namespace suture
