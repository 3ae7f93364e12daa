// A closed surface sampled on the physics grid: cells near it, how far it is there, what is inside.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "kernel/triangles.h"
#include "sims/fluid/grid/surface_cells.h"

namespace suture::sims {

/// Signed distance to a surface, negative inside; as a SurfaceTracker's.
using DistanceFunction = std::function<double(const Point&)>;

inline constexpr int kNear = 2;  ///< cells: D is exact within so many of the surface
inline constexpr int kFar = 3;   ///< cells: how far away all else is said to be

/// A body that holds no cell's centre: as liquid it has no pressure.
struct SubgridDroplet {
  std::vector<std::uint32_t> vertices;  ///< of the surface, sorted
  std::vector<Index3> cells;            ///< that it is in, sorted
};

/// A surface's samples, on a grid of the blocks near it alone.
struct SampledSurface {
  /// Cells in a row along the last axis.
  struct Run {
    Index3 first;
    int count;
  };
  SparseGrid grid;
  std::vector<std::uint8_t> near;                      ///< a slot each: whether D is exact there
  std::vector<double> distance;                        ///< a slot each: D at the cell's centre
  std::vector<Run> deep;                               ///< the cells inside that are not near
  std::array<std::vector<FaceCrossing>, 3> crossings;  ///< by axis, sorted by face
  std::vector<SubgridDroplet> droplets;
};

/// Asks for D, on all threads, once a cell with a triangle within `near` cells, and fills between
/// those: the inside of a big body costs nothing a cell. D is ±kFar·h where it is not asked for.
/// \throw InvalidInput if the frame's h is not finite and positive, an index is out of range, or a
/// position is not finite or 2^29 cells or further off
SampledSurface sample_surface(const Triangles& surface, const DistanceFunction& distance,
                              const GridFrame& frame, int near = kNear);

/// A grid with all cells within `band` cells, on each axis, of those inside or met by the surface.
SparseGrid grid_round(const SampledSurface& sampled, int band);

}  // namespace suture::sims
