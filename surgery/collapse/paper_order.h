// The paper's own order: type 2 vertices collapse before the region's mesh is dropped and filled
// [§6.1 steps 3 and 4, §6.2].
#pragma once

#include <vector>

#include "surgery/collapse/rules.h"
#include "surgery/operate/cut.h"
#include "surgery/operate/stitch.h"

namespace suture::surgery {

/// The arcs of one face of a region cell, end to end: from type 1 vertex to type 1 vertex over the
/// type 2 vertices between them.
struct ArcChain {
  LatticeId cell;
  int face;                          ///< of the cell, as in Arc
  std::vector<std::uint32_t> sites;  ///< two or more
};

/// \pre every arc is part of a chain between type 1 sites: no closed loop is on the boundary
std::vector<ArcChain> chains_of(const std::vector<Arc>& boundary, const Sites& sites);

/// The number of chains that have a type 2 vertex left in the mesh that was sewn.
std::size_t bent_arcs(const std::vector<ArcChain>& chains, const Sewing& sewing);

/// The mesh without the region's triangles, and the arcs that bound the hole.
struct OpenedMesh {
  CollapseCounts collapses;
  std::vector<Arc> boundary;          ///< straight arcs, one a chain; empty after a gridlock
  std::vector<LatticeId> gridlocked;  ///< cells across from arcs that are still bent, sorted
  std::size_t bent_arcs = 0;
};

/// Subdivides the mesh along the region's boundary, keeping it closed; collapses type 2 vertices
/// along their arcs while no rule forbids it; drops the triangles in the region. A collapse is
/// delayed where it would join two type 1 vertices other than the ends of the arc that it makes
/// straight. Where an arc stays bent, that is a gridlock: the mesh is then to be thrown away.
/// \pre `cut` has its inside made
OpenedMesh open_in_paper_order(const CutMesh& cut, Sewing& sewing, const CollapseRules& rules);

}  // namespace suture::surgery
