// The exact shape at time 0 carried by the exact flow: a triangulation as fine as its image asks.
#pragma once

#include <functional>
#include <utility>

#include "sims/study/exact/exact_shape.h"

namespace suture::sims {

/// A carry sends a point of time 0 to where it is at the time asked for.
using Carry = std::function<Point(const Point&)>;

/// Points are carried through a scene's motions from time 0 to `time` by the Runge–Kutta–Fehlberg
/// method of order 8, each point with steps of its own that err by no more than `error`, in the
/// scene's unit. \throw InvalidInput if a motion of the scene is no velocity field
Carry exact_carry(const Scene& scene, double time, double error);

struct ExactFlowOptions {
  double tolerance = 0;                  ///< of chords, in the scene's unit; must be above zero
  std::size_t most_triangles = 8000000;  ///< more are surely a mistake
};

/// A carried shape. Creases are pairs of vertices, corners vertices where three faces meet.
struct ExactSurface {
  Triangles surface;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> creases;
  std::vector<std::uint32_t> corners;
  double tolerance = 0;
  /// The reference's own error: the distances of the shape's image from the middles of 5,000
  /// triangles that are spread over all.
  double mean_error = 0, max_error = 0;
};

/// Edges are cut in two, new vertices placed on the shape at time 0 and carried, until the image of
/// every edge's middle is within the tolerance of its triangles; of a crease's, of its chord; and
/// that of every triangle's middle within twice the tolerance of it.
/// \throw InvalidInput if that takes too many triangles or the tolerance is not positive
ExactSurface exact_flow(const ExactShape& shape, const Carry& carry,
                        const ExactFlowOptions& options);

}  // namespace suture::sims
