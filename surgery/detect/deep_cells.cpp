// The deep-cell test reads no distances: a cell is `depth` cells from the isosurface when no cell
// of the (2·depth + 1)³ block round it has corners on both sides [§5.3].
#include "surgery/detect/deep_cells.h"

#include <algorithm>

namespace suture::surgery {

namespace {

bool is_deep(const CellSet& set, const Index3& cell, int depth) {
  for (int i = -depth; i <= depth; ++i)
    for (int j = -depth; j <= depth; ++j)
      for (int k = -depth; k <= depth; ++k) {
        const Index3 at = {cell[0] + i, cell[1] + j, cell[2] + k};
        if (std::min({at[0], at[1], at[2]}) < 0) continue;
        const SurfaceCell* near = set.cells.find(pack(at));
        if (near && near->mixed) return false;
      }
  return true;
}

/// The smallest and the largest winding at the cell's corners.
std::pair<int, int> corner_windings(const Winding& winding, const Index3& cell) {
  int low = winding.at(cell), high = low;
  for (int corner = 1; corner < 8; ++corner) {
    const int w = winding.at(
        {cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2 & 1)});
    low = std::min(low, w);
    high = std::max(high, w);
  }
  return {low, high};
}

}  // namespace

EventCells find_events(const CellSet& set, const Winding& winding, const EventTest& test) {
  EventCells found;
  MarkedCells& marked = found.marked;
  if (test.events == Events::none) return found;
  for (std::size_t i = 0; i < set.cells.size(); ++i) {
    const SurfaceCell& cell = set.cells.values()[i];
    if (!cell.complex) continue;  // a cell at a node of winding 2 or −1 is complex too
    const Index3 at = unpack(set.cells.keys()[i]);
    const auto [low, high] = corner_windings(winding, at);
    const bool inside = low >= 1, outside = high < 1;
    std::size_t* cause = nullptr;
    if (test.cell_test == CellTest::plain) {
      const bool allowed = (merges(test.events) && !outside) || (splits(test.events) && !inside);
      if (allowed) cause = &marked.plain;
    } else if ((inside && merges(test.events)) || (outside && splits(test.events))) {
      if (is_deep(set, at, test.depth)) cause = inside ? &marked.deep_inside : &marked.deep_outside;
    }
    if (!cause && high > 1 && merges(test.events)) cause = &marked.self_intersecting;
    if (!cause && low < 0 && splits(test.events)) cause = &marked.inverted;
    if (!cause) continue;
    ++*cause;
    found.cells.push_back(set.cells.keys()[i]);
  }
  std::sort(found.cells.begin(), found.cells.end());
  return found;
}

}  // namespace suture::surgery
