// Drops for the tests of surface tension and volume control, in places that no symmetry favours.
#pragma once

#include "kernel/random.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "surgery/tracker.h"

namespace suture {

inline const Point kDropCentre(0.13, 0.21, 0.07);

inline Triangles drop(double radius, double edge) { return sphere({kDropCentre, radius, edge}); }

inline Point random_vector(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// The vertices put back onto the ball.
inline Triangles onto_ball(Triangles surface, double radius) {
  for (Point& p : surface.positions) p = kDropCentre + radius * (p - kDropCentre).normalized();
  return surface;
}

/// Vertices moved at random along the ball.
inline Triangles shuffled(Triangles ball, double radius, double most) {
  Random random(3);
  for (Point& p : ball.positions) p += most * random_vector(random);
  return onto_ball(std::move(ball), radius);
}

/// A drop after surgery on all of its surface, with its vertices put back onto the ball.
inline Triangles remodelled(double radius, double edge) {
  const Triangles ball = drop(radius, edge);
  const Triangles turned = translated(rotated(translated(ball, -kDropCentre), {1, 2, 3}, 0.3),
                                      kDropCentre);  // they cross all over
  Tracker tracker(merged(std::vector{ball, turned}), {.cell_size = edge});
  tracker.remodel();
  tracker.improve();
  return onto_ball(tracker.surface(), radius);
}

}  // namespace suture
