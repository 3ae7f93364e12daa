// The ground of the baselines on grids: surfaces to narrow bands of distances, and zero sets to
// surfaces.
#pragma once

#include <openvdb/openvdb.h>

#include <functional>

#include "kernel/isosurface/marching_tetrahedra.h"
#include "kernel/measure/nearest_triangle.h"
#include "kernel/triangles.h"

namespace suture::sims {

/// A lattice with a node at `origin`, and a band of nodes on it round a surface. Grids know nothing
/// of it: their space is that of the indices, and their distances are in cells, so scale is no
/// matter to OpenVDB (which has absolute tolerances) or to its single precision.
struct BandOptions {
  double cell_size = 0;
  Point origin = Point::Zero();
  double half_width = 3;  ///< cells on either side in which nodes hold values

  Point place(const openvdb::Coord& node) const {
    return origin + cell_size * Point(node[0], node[1], node[2]);
  }
  /// The point `p` in index space.
  openvdb::Vec3d index(const Point& p) const {
    const Point i = (p - origin) / cell_size;
    return {i[0], i[1], i[2]};
  }
};

/// \throw InvalidInput unless the cell size is a positive normal number, the origin finite and the
/// half width at least 1
void require_valid(const BandOptions& options);

/// \throw InvalidInput if the band is farther than 2¹⁹ cells from the origin
void require_within_reach(const openvdb::FloatGrid& grid);

/// Exact signed distances, in cells, at the nodes less than half_width cells from the surface;
/// elsewhere ± half_width, by flood fill. A level set for OpenVDB's tools, empty for an empty
/// surface. \throw InvalidInput if the surface is not finite or more than 2¹⁹ cells from the origin
openvdb::FloatGrid::Ptr make_level_set(const Triangles& surface, const BandOptions& options);

/// The same with any function in place of the distance, on the nodes that `near` finds in the band;
/// values beyond the half width stay, and so do their nodes.
openvdb::DoubleGrid::Ptr make_band(const Triangles& near, const BandOptions& options,
                                   const std::function<double(const Point&)>& value);

/// Whether every cube whose corners are not on one side has all of them in the band.
bool holds_zero_set(const openvdb::DoubleGrid& grid);

/// The zero set of a grid by marching tetrahedra over all cubes that have a node of a leaf as a
/// corner; closed, manifold and embedded if the tiles beyond do not change sign among themselves.
/// A node with the value 0 is outside. `place` as for MarchingTetrahedra.
template <class Grid>
Triangles contour(const Grid& grid, const MarchingTetrahedra::Place& place);
/// The same, with vertices where the values, taken as linear on each edge, are zero.
Triangles contour(const openvdb::FloatGrid& grid, const BandOptions& options);

/// Trilinear between the nodes, in cells; ± the half width outside the band.
double sampled(openvdb::FloatGrid::ConstAccessor& values, const openvdb::Vec3d& index);

}  // namespace suture::sims
