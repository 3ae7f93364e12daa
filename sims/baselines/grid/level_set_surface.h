// Between triangles and a dense level set: exact distances one way, marching tetrahedra the other.
#pragma once

#include "sims/baselines/grid/dense_level_set.h"

namespace suture::sims {

/// The place of the grid in the scene, in the scene's unit.
struct GridFrame {
  double cell_size = 1;
  Point origin = Point::Zero();  ///< node (0, 0, 0)

  Point cells(const Point& scene) const { return (scene - origin) / cell_size; }
  Point scene(const Point& cells) const { return origin + cell_size * cells; }
};

/// Exact signed distances at all nodes nearer than `width` cells to the surface, ± width elsewhere.
/// \pre the surface is closed and not empty \throw InvalidInput if the box has more than 2²⁸ nodes
DenseLevelSet dense_level_set(const Triangles& surface, const GridFrame& frame, double width);

/// The zero surface, closed, manifold and oriented outwards, in the scene's unit; empty if there is
/// none. Vertices are at the linear zeros on the tetrahedra's edges.
Triangles zero_surface(const DenseLevelSet& set, const GridFrame& frame);

}  // namespace suture::sims
