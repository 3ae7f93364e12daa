// The measures of a surface by itself: its topology and its worst places.
#pragma once

#include "kernel/triangles.h"

namespace suture::sims {

/// Counts, as doubles for tables.
struct SurfaceMeasures {
  double components = 0, euler = 0;
  double intersecting_pairs = 0;  ///< of triangles, counted up to a million
  double without_area = 0;        ///< triangles
  double least_angle = 0;         ///< degrees
};

/// \pre indices in range, finite positions
SurfaceMeasures measure_surface(const Triangles& surface);

}  // namespace suture::sims
