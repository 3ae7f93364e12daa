// Distance from a point to the nearest triangle of a surface, and rays, by a tree of boxes.
#pragma once

#include <memory>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// The distance of `p` from the triangle (a, b, c), exact to rounding of the coordinates, for
/// slivers and triangles without area too. \pre the squares of the coordinates are in the range of
/// doubles
double distance_to_triangle(const Point& p, const Point& a, const Point& b, const Point& c);

/// The triangles of one surface, made ready for many questions. Any number of threads may ask at
/// once.
class NearestTriangle {
 public:
  /// Copies what it needs, so `surface` may go. It takes O(n log n). \throw InvalidInput if the
  /// surface has no triangle, a coordinate that is not finite or an index out of range
  explicit NearestTriangle(const Triangles& surface);
  ~NearestTriangle();
  NearestTriangle(NearestTriangle&&) noexcept;
  NearestTriangle& operator=(NearestTriangle&&) noexcept;

  /// The distance to the nearest triangle, exact to rounding, at any scale. \pre p is finite
  double distance(const Point& p) const;
  /// The nearest triangle; of equally near ones the one with the lowest index. \pre p is finite
  std::uint32_t triangle(const Point& p) const;
  /// Adds to `found`, in a defined order, the triangles whose boxes the ray from p along the first
  /// axis meets: all that it can cross, and few others. \pre p is finite
  void along_first_axis(const Point& p, std::vector<std::uint32_t>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace suture
