// Breadth-first flood across complex faces; it ends because only surface cells can be reached
// [§5.3].
#include "surgery/detect/region.h"

namespace suture::surgery {

int Region::cells_round_edge(LatticeId edge, int axis) const {
  int count = 0;
  suture::cells_round_edge(edge, axis, [&](LatticeId cell) { count += holds(cell) ? 1 : 0; });
  return count;
}

Region grow_region(const std::vector<LatticeId>& seeds, const CellSet& set) {
  Region region;
  for (const LatticeId seed : seeds) region.cells.index(seed);
  for (std::size_t next = 0; next < region.cells.size(); ++next) {  // keys() grows as we go
    const LatticeId cell = region.cells.keys()[next];
    for (int axis = 0; axis < 3; ++axis) {
      if (set.complex_faces[axis].contains(cell)) region.cells.index(step(cell, axis, -1));
      const LatticeId above = step(cell, axis, 1);
      if (set.complex_faces[axis].contains(above)) region.cells.index(above);
    }
  }
  return region;
}

}  // namespace suture::surgery
