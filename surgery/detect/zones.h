// Zones that the allowed events leave alone: a region that touches one takes it in whole, or the
// fill, which draws one sheet a cell, would change sides there.
#pragma once

#include "surgery/detect/deep_cells.h"
#include "surgery/detect/region.h"

namespace suture::surgery {

/// All that a region reads while it grows. All must outlive the growth.
struct Ground {
  const CellSet& cells;
  const Winding& winding;
  Events events;
};

/// Adds to the region the cells that hold mesh and have a corner in a zone that it touches, and
/// floods on, until nothing is added. A zone is a set of nodes of windings other than 0 and 1 that
/// lattice edges join; it is touched where a corner of the region is in it. With both events all
/// such cells are seeds, so nothing is added, and without a node of the winding that the events
/// leave alone nothing is looked at. Afterwards every lattice edge that the mesh meets and that is
/// not interior has both windings in {0, 1} or no end in a touched zone [papers/proof.md, 9.3].
Region grow_over_zones(Region region, const Ground& in);

}  // namespace suture::surgery
