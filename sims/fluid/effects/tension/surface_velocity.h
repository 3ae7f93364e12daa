// Values at the vertices of a surface, asked for at points near it.
#pragma once

#include <vector>

#include "kernel/measure/nearest_triangle.h"
#include "kernel/triangles.h"

namespace suture::sims {

/// A place on a surface: a triangle, and the weights of its corners, each 0 to 1, together 1.
struct SurfacePlace {
  Triangle corners;
  Point weights;
};

/// The place nearest to p. \pre `nearest` is of `surface`, p is finite
SurfacePlace nearest_place(const Triangles& surface, const NearestTriangle& nearest,
                           const Point& p);

/// Velocities of a surface's vertices as a field: at p that of the nearest place, linear over its
/// triangle. Keeps the surface as it was, so that it may move meanwhile. Any number of threads ask.
class SurfaceVelocity {
 public:
  /// \pre a velocity a vertex \throw InvalidInput as NearestTriangle
  SurfaceVelocity(Triangles surface, std::vector<Point> velocity)
      : surface_(std::move(surface)), velocity_(std::move(velocity)), nearest_(surface_) {}

  Point at(const Point& p) const {
    const SurfacePlace place = nearest_place(surface_, nearest_, p);
    Point v = Point::Zero();
    for (int k = 0; k < 3; ++k) v += place.weights[k] * velocity_[place.corners[k]];
    return v;
  }
  std::size_t memory() const {  // the tree's items are as large as the triangles' corners
    return (surface_.positions.size() + velocity_.size() + 4 * surface_.triangles.size()) *
           sizeof(Point);
  }

 private:
  Triangles surface_;
  std::vector<Point> velocity_;
  NearestTriangle nearest_;
};

}  // namespace suture::sims
