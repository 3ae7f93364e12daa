// Better-shaped triangles without new vertices, by flips and by sliding vertices along the surface.
#pragma once

#include <functional>
#include <span>

#include "kernel/triangles.h"

namespace suture {

/// How often to relax, and which vertices and triangles the smooth surface allows.
struct RelaxOptions {
  /// The number of sweeps that come first. Each vertex goes to the mean of its neighbours where
  /// that is admissible, so that vertices spread from where they are dense.
  int even_sweeps = 0;
  /// The number of sweeps that follow, with flips, and moves that make no smallest angle worse.
  int sweeps = 10;
  /// Takes a point near the surface to one on it.
  std::function<Point(const Point&)> project;
  /// Whether a triangle may exist. It holds for all the given ones and is kept so. It should imply
  /// that the patch stays embedded, as "counter-clockwise seen from the centre" does on a
  /// star-shaped surface.
  std::function<bool(const Point&, const Point&, const Point&)> admissible;
};

/// Raises the smallest angles of an oriented manifold patch, in place. The edges and vertices of
/// its border stay. The same input gives the same bits. \pre `triangles` index `positions`; at most
/// two are at an edge, and run along it opposite ways
void relax(std::vector<Point>& positions, std::span<Triangle> triangles,
           const RelaxOptions& options);

}  // namespace suture
