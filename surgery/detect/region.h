// The region to be re-sampled: events, grown until its boundary is simple [§5.3].
#pragma once

#include <vector>

#include "surgery/detect/complex_cells.h"

namespace suture::surgery {

/// The cells whose mesh is cut out and replaced.
struct Region {
  SparseField<char> cells;

  bool empty() const { return cells.empty(); }
  bool holds(LatticeId cell) const { return cells.contains(cell); }
  /// The number of the four cells round the lattice edge along `axis` that are in the region.
  int cells_round_edge(LatticeId edge, int axis) const;
};

/// Detection's findings, which cut, fill and audit read: the mesh on its shifted lattice, where it
/// crosses that, the windings of the nodes, and the region. All must outlive it.
struct Detected {
  const Incidence& mesh;
  ShiftedLattice on;
  const Crossings& crossings;
  const Winding& winding;
  const Region& region;

  CrossedMesh crossed() const { return {mesh, on, crossings}; }
};

/// Floods from the seeds across complex faces. Afterwards no complex edge and no face with a closed
/// loop is on the region's boundary: each boundary edge is crossed at most once, from inside to
/// outside.
Region grow_region(const std::vector<LatticeId>& seeds, const CellSet& set);

}  // namespace suture::surgery
