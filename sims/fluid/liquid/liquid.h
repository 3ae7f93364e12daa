// Which cells of the physics grid are liquid, from the tracked surface.
#pragma once

#include <array>
#include <vector>

#include "kernel/triangles.h"
#include "sims/fluid/grid/sampled_surface.h"
#include "sims/fluid/solids/solid_faces.h"

namespace suture::sims {

/// Marks the cells of a grid that are liquid.
struct Liquid {
  SharedGrid grid;
  /// D at cell centres, a slot each: exact within kNear cells of the surface, ±kFar·h of the right
  /// sign elsewhere. In walls it is that of the liquid continued into them: see liquid_on.
  std::vector<double> distance;
  std::array<std::vector<FaceCrossing>, 3> crossings;  ///< by axis, sorted by face
  std::vector<Slot> droplet_cells;  ///< cells of bodies that hold no cell's centre, sorted

  bool inside(Slot s) const { return distance[s] < 0; }
  /// How far the surface is from the centre of the cell inside, as a part, 0 to 1, of the way to
  /// the other cell's, at a face with one of each. It is that of the surface itself, not made from
  /// two distances, which near a wall are those to the wall's side of the liquid.
  double way_to_surface(int axis, Slot face) const;
  std::size_t memory() const;
};

/// The room in which liquid may flow: its cells, and the part of their faces that solids leave
/// open.
struct FlowDomain {
  const Liquid& liquid;
  const SolidFaces& solids;
};

/// Calls f(axis, face, cell, point) for each face between a cell inside and one outside: `cell` is
/// the one inside, `point` where the surface leaves on the way from its centre to the other's.
template <class F>
void for_each_crossing(const Liquid& liquid, F f) {
  const SparseGrid& grid = *liquid.grid;
  for (int axis = 0; axis < 3; ++axis)
    for (Slot s = 0; s < grid.size(); ++s) {
      const Slot below = grid.neighbour(s, axis, -1);
      if (below == kNoSlot || liquid.inside(s) == liquid.inside(below)) continue;
      const bool up = liquid.inside(below);
      const Slot cell = up ? below : s;
      Point at = grid.centre(grid.cell(cell));
      at[axis] += (up ? 1 : -1) * grid.h() * liquid.way_to_surface(axis, s);
      f(axis, s, cell, at);
    }
}

/// Liquid without solids. \pre the grid is not null and has the origin and h of `sampled`
Liquid liquid_on(SharedGrid grid, const SampledSurface& sampled);

/// Air between a wall and liquid is none where it is thinner than this, in cells: it would be a
/// place without pressure under water.
inline constexpr double kThinnestAir = 0.5;

/// The same, continued into solids. A cell whose centre is in a solid, or in air as thin as that,
/// is liquid where the plane of the nearest free triangle says so, or, with none within kNear
/// cells, where the liquid touches the solid. \pre `sampled` is of `surface`
Liquid liquid_on(SharedGrid grid, const SampledSurface& sampled, const Triangles& surface,
                 const SolidsAt& solids);

}  // namespace suture::sims
