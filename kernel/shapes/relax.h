// Better-shaped triangles without a new vertex: flips, and vertices that slide along the surface.
#pragma once

#include <functional>
#include <span>

#include "kernel/triangles.h"

namespace suture {

/// What a triangle or vertex of a known smooth surface must satisfy.
struct RelaxOptions {
  int even_sweeps = 0;  ///< first: each vertex goes to the mean of its neighbours where admissible,
                        ///< so that vertices spread from where they are dense
  int sweeps = 10;      ///< then: flips, and moves that make no triangle's smallest angle worse
  std::function<Point(const Point&)> project;  ///< a point near the surface to one on it
  /// Whether a triangle may exist: true of all the given ones, and kept so. Chosen to imply that
  /// the patch stays embedded, say "seen from the centre, counter-clockwise" on a star-shaped one.
  std::function<bool(const Point&, const Point&, const Point&)> admissible;
};

/// Raises the smallest angles of an oriented manifold patch, in place. Its border stays, edges and
/// vertices. Deterministic.
/// \pre `triangles` index `positions`, at most two at an edge, which run along it opposite ways
void relax(std::vector<Point>& positions, std::span<Triangle> triangles,
           const RelaxOptions& options);

}  // namespace suture
