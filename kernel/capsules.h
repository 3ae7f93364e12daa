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

/// Its surface, closed and oriented, with edges of about edge_length, relaxed.
/// \pre the surface is inside of `box` by two cells of 1.9 edge lengths
Triangles skin(const CapsuleUnion& capsules, const Box& box, double edge_length);

inline constexpr double kSkinCellsPerEdge = 1.9;  ///< measured: edges of edge_length on average

}  // namespace suture
