// The report of one remodel or one improvement: returned, never printed.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"
#include "predicates/oracle.h"

namespace suture {

enum class Outcome {
  unchanged,  ///< nothing to do: the mesh is the same to the last bit
  committed,  ///< the surgery passed its audit and is the mesh now
  refused     ///< the surgery failed its audit: the mesh is the one before, `failure` says why
};

/// Cells put into the region, by the first cause that marked them.
struct MarkedCells {
  std::size_t deep_inside = 0, deep_outside = 0, self_intersecting = 0, inverted = 0, plain = 0,
              flooded = 0;
  /// Round zones of winding −1 or 2 that the region touches and that the events alone would leave.
  std::size_t overlapped = 0;
  std::size_t gridlocked = 0;  ///< by regrowths, with what these flooded [§6.2]
  std::size_t total() const {
    return deep_inside + deep_outside + self_intersecting + inverted + plain + flooded +
           overlapped + gridlocked;
  }
};

struct CollapseCounts {
  std::size_t done = 0;
  std::size_t delayed = 0;  ///< no neighbour to become, or only ones it would join too early [§6.2]
  std::size_t blocked = 0;  ///< attempts refused, however often the same vertex was tried
  std::size_t refused_link = 0, refused_normal = 0, refused_node = 0, refused_volume = 0,
              refused_feature = 0;
};

/// A body that surgery left nothing of, since it was thinner than a cell; or a cavity, of negative
/// volume, that it filled. Lengths are in the scene's unit.
struct VanishedBody {
  double volume;
  Point centre;  ///< of its bounding box
};

struct SurgeryReport {
  Outcome outcome = Outcome::unchanged;
  std::string failure;  ///< why it was refused

  std::size_t crossings = 0;  ///< mesh edges × planes and triangles × lattice lines
  std::size_t surface_cells = 0, complex_cells = 0;
  MarkedCells marked;

  std::size_t type1_vertices = 0, type2_vertices = 0, isosurface_vertices = 0,
              centroid_vertices = 0;
  std::size_t triangles_removed = 0, triangles_added = 0, loops = 0;
  std::size_t coincident_triangles = 0;  ///< of bodies that were exact copies of others, dropped
  std::size_t split_triangles =
      0;                      ///< cut triangles whose pieces could not be merged into polygons
  std::size_t bent_arcs = 0;  ///< that kept a type 2 vertex; with Collapse::paper over all tries
  std::size_t regrowths = 0;  ///< gridlocks: the region grew and surgery started again [§6.2]
  std::size_t recuts = 0;     ///< times the audit asked for a second cut, cell by cell
  CollapseCounts collapses;
  OracleCounts oracle;

  double volume_before = 0, volume_after = 0;
  std::int64_t euler_before = 0, euler_after = 0;
  std::size_t components_before = 0, components_after = 0;
  std::vector<VanishedBody> vanished;  ///< components before that neither stayed nor merged

  std::vector<std::pair<std::string, double>> seconds;  ///< per stage, in order
  std::vector<std::uint32_t> vertex_map;  ///< old vertex → new one, or kNone where it went
  std::vector<LatticeId>
      region;  ///< the cells re-sampled, in the lattice of the surface before (surgery_check.h)
};

struct QualityReport {
  std::size_t subdivisions = 0, flips = 0;
  std::size_t flattened = 0;  ///< obtuse corners put onto their longest edge
  CollapseCounts collapses;
  std::size_t refused_flips = 0;
  double smallest_angle = 0, shortest_edge = 0, longest_edge = 0;  ///< afterwards; degrees, lengths
  std::vector<std::uint32_t> vertex_map;                           ///< as in SurgeryReport
};

}  // namespace suture
