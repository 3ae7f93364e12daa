// A closed surface on the physics grid: cells near it, and where it crosses between their centres.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "kernel/triangles.h"
#include "sims/fluid/grid/sparse_grid.h"

namespace suture::sims {

/// A triangle's corners in units of cells: a cell's centre is at its whole indices.
using CellTriangle = std::array<Point, 3>;
CellTriangle in_cells(const Triangles& surface, const Triangle& triangle, const SparseGrid& grid);

/// The cells of which the centre is within `wider` of a triangle's box on each axis, both ends in.
struct CellRange {
  Index3 low, high;
};
CellRange cells_round(const CellTriangle& triangle, double wider);

/// The blocks with all cells whose centre is within `width` cells of a triangle's box on each axis.
/// \throw InvalidInput as sample_surface
SparseGrid blocks_near(const Triangles& surface, const GridFrame& frame, int width);

/// Marks the cells whose centre is within `width` cells of a triangle's plane and of its box: all
/// that are so near the triangle, and few others.
std::vector<std::uint8_t> cells_near(const Triangles& surface, const SparseGrid& grid, int width);

/// The surface's crossings of the way between the centres of the two cells at a face: the lowest
/// and the highest place, as parts of the way up.
struct FaceCrossing {
  Slot face;
  double lowest, highest;
};

/// Finds the crossings of the surface with the lines through cell centres along an axis, sorted by
/// face. A line
/// through an edge or a vertex meets the triangles on both sides of it.
std::vector<FaceCrossing> crossings_along(const Triangles& surface, const SparseGrid& grid,
                                          int axis);

}  // namespace suture::sims
