// Tubes: a polygon extruded along stations. Rolls, rings, needles and tangles are made of them.
#pragma once

#include <vector>

#include "kernel/triangles.h"

namespace suture::sims {

enum class Ends { capped, joined };

/// A closed oriented manifold through `stations`, each the same polygon's vertices in the same
/// order, counter-clockwise seen from the stations ahead. Its ends are capped by fans or joined to
/// a ring. \pre two stations (a ring: three) or more, all of three points or more
Triangles extrude(const std::vector<std::vector<Point>>& stations, Ends ends);

struct TubeShape {
  double radius = 0.1;
  int sides = 4;
  Ends ends = Ends::capped;
};

/// A tube round the points of a polyline. \pre two points (a ring: three) or more
Triangles tube(const std::vector<Point>& middle, const TubeShape& shape);

}  // namespace suture::sims
