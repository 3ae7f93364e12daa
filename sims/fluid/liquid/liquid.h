// Which cells of the physics grid are liquid, from the tracked surface.
#pragma once

#include <functional>
#include <vector>

#include "kernel/triangles.h"
#include "sims/fluid/grid/sparse_grid.h"
#include "sims/fluid/solids/solids.h"

namespace suture::sims {

/// Signed distance to the liquid's surface, negative inside; as a SurfaceTracker's.
using DistanceFunction = std::function<double(const Point&)>;

inline constexpr int kNear = 2;  ///< cells: D is exact within so many of the surface
inline constexpr int kFar = 3;   ///< cells: how far away all else is said to be

/// Where the surface crosses the way between the centres of the two cells at a face: the lowest and
/// the highest place, as parts of the way up.
struct FaceCrossing {
  Slot face;
  double lowest, highest;
};

/// A body of liquid that holds no cell's centre, and so has no pressure.
struct Drop {
  std::vector<std::uint32_t> vertices;  ///< of the surface, sorted
  std::vector<Index3> cells;            ///< that it is in, sorted
};

/// The liquid before the physics grid is there, by a grid of the blocks near its surface alone.
struct LiquidCells {
  struct Run {  ///< of cells along the last axis
    Index3 first;
    int count;
  };
  SparseGrid grid;
  std::vector<std::uint8_t> near;                      ///< a slot each: whether D is exact there
  std::vector<double> distance;                        ///< a slot each, as in Liquid
  std::vector<Run> deep;                               ///< the cells inside that are not near
  std::array<std::vector<FaceCrossing>, 3> crossings;  ///< by axis, sorted by face
  std::vector<Drop> drops;
};

/// Asks for D, on all threads, once a cell with a triangle within `near` cells, and fills between
/// those: the inside of a big body costs nothing a cell. A body too small to hold a cell's centre
/// is told of. \throw InvalidInput if h is not finite and positive, an index is out of range, or a
/// position is not finite or 2^29 cells or further off
LiquidCells find_liquid(const Triangles& surface, const DistanceFunction& distance,
                        const Point& origin, double h, int near = kNear);

/// A grid with all cells within `band` cells, on each axis, of those inside or met by the surface.
SparseGrid grid_round(const LiquidCells& cells, int band);

/// Which cells of a grid are liquid.
struct Liquid {
  const SparseGrid* grid = nullptr;
  /// D at cell centres, a slot each: exact within kNear cells of the surface, ±kFar·h of the right
  /// sign elsewhere. In walls it is that of the liquid continued into them: see liquid_on.
  std::vector<double> distance;
  std::array<std::vector<FaceCrossing>, 3> crossings;  ///< by axis, sorted by face
  std::vector<Slot> drops;  ///< cells of bodies that hold no cell's centre, sorted

  bool inside(Slot s) const { return distance[s] < 0; }
  /// How far from the centre of the cell inside to that of the other the surface is, at a face with
  /// one of each: from the surface itself, not from two distances, which near a wall are those to
  /// the wall's side of the liquid. 0 to 1.
  double share(int axis, Slot face) const;
  std::size_t memory() const;
};

/// Air between a wall and liquid is none where it is thinner than this, in cells: it would be a
/// place without pressure under water.
inline constexpr double kThinnestAir = 0.5;

/// A cell whose centre is in a solid, or in air as thin as that, is liquid where the plane of the
/// nearest free triangle says so, or, with none within kNear cells, where the liquid touches the
/// solid. \pre the grid has the origin and h of `cells`, which are of `surface`
Liquid liquid_on(const SparseGrid& grid, const LiquidCells& cells, const Triangles& surface = {},
                 const Solids& solids = {}, double t = 0);

}  // namespace suture::sims
