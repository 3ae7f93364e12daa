// Which cells of the physics grid are liquid, from the tracked surface.
#pragma once

#include <functional>
#include <vector>

#include "kernel/triangles.h"
#include "sims/fluid/solids.h"
#include "sims/fluid/sparse_grid.h"

namespace suture {

/// Signed distance to the liquid's surface, negative inside; as a SurfaceTracker's.
using DistanceFunction = std::function<double(const Point&)>;

inline constexpr int kNear = 2;  ///< cells: within so many of the surface D is exact
inline constexpr int kFar = 3;   ///< cells: what D is said to be further away

/// The liquid's cells before there is a grid. Costs what the surface has of cells, not the volume.
struct LiquidCells {
  /// Cells in a row along the last axis.
  struct Run {
    Index3 first;
    int count;
  };
  /// Where the surface crosses the way from a cell's centre to that of the next one up an axis:
  /// the lowest and the highest place, as parts of the way.
  struct Crossing {
    Index3 cell;
    double lowest, highest;
  };
  Point origin = Point::Zero();
  double h = 0;
  std::vector<Index3> near;      ///< cells whose centre is within kNear cells of a triangle, sorted
  std::vector<double> distance;  ///< D at their centres
  std::vector<Run> deep;         ///< all other cells inside, sorted
  std::array<std::vector<Crossing>, 3> crossings;  ///< by axis, sorted by cell
  std::vector<Index3> drops;   ///< cells of bodies of liquid that hold no cell centre, sorted
  std::size_t drop_count = 0;  ///< such bodies
};

/// Asks for D once a near cell; the inside of a big body is filled between near cells.
/// \throw InvalidInput if h is not finite and positive, or the surface has broken indices, numbers
/// that are not finite, or lies 2^29 cells or further off
LiquidCells find_liquid(const Triangles& surface, const DistanceFunction& distance,
                        const Point& origin, double h);

/// The grid that holds all cells within `band` cells of the liquid on each axis.
SparseGrid grid_round(const LiquidCells& cells, int band);

/// Which cells of a grid are liquid.
struct Liquid {
  const SparseGrid* grid = nullptr;
  /// D at cell centres, a slot each: exact within kNear cells of the surface, ±kFar·h of the right
  /// sign elsewhere. Where a centre is in a solid D is that of the liquid which the solid bounds,
  /// continued into it, so that a wall does not look like air.
  std::vector<double> distance;
  /// Where the surface crosses the way between the centres on both sides of a face: sorted by slot.
  struct Crossing {
    Slot face;
    double lowest, highest;  ///< parts of the way from the cell below to the cell above
  };
  std::array<std::vector<Crossing>, 3> crossings;
  std::vector<Slot> drops;  ///< cells of bodies of liquid too small to hold a cell centre

  bool inside(Slot s) const { return distance[s] < 0; }
  /// How far the surface is from the centre of the inside one of the two cells at a face towards
  /// the other one's, as a part of the way, 0 to 1. \pre one is inside and the other is not
  double share(int axis, Slot face) const;
  std::size_t memory() const;
};

/// \pre the grid is that of `cells` or has the same origin and h; solids as they are at time t
Liquid liquid_on(const SparseGrid& grid, const LiquidCells& cells, const DistanceFunction& distance,
                 const Solids& solids = {}, double t = 0);

}  // namespace suture
