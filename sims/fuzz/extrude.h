// Tubes: a polygon carried along stations. Rolls, rings, needles and tangles are made of them.
#pragma once

#include <vector>

#include "kernel/triangles.h"

namespace suture::sims {

/// A closed oriented manifold through `stations`, each the same polygon's vertices in the same
/// order, counter-clockwise seen from the stations ahead. Its ends are capped by fans, or joined
/// where `ring` is set. \pre two stations (a ring: three) or more, all of three points or more
enum class Ends { capped, joined };
Triangles sweep(const std::vector<std::vector<Point>>& stations, Ends ends);

/// A tube of `sides` round the points of a polyline, `radius` wide. \pre two points (a ring: three)
struct TubeShape {
  double radius = 0.1;
  int sides = 4;
  Ends ends = Ends::capped;
};
Triangles tube(const std::vector<Point>& middle, const TubeShape& shape);

}  // namespace suture::sims
