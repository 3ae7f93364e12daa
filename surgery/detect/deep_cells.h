// Which complex cells call for a change of topology [§5.3].
#pragma once

#include <vector>

#include "surgery/detect/complex_cells.h"
#include "surgery/model/options.h"
#include "surgery/model/report.h"

namespace suture::surgery {

constexpr bool merges(Events e) { return e == Events::merge || e == Events::both; }
constexpr bool splits(Events e) { return e == Events::split || e == Events::both; }

struct EventTest {
  Events events = Events::both;
  CellTest cell_test = CellTest::deep;
  int depth = 1;
};

/// The cells at which topology changes: complex cells at least `depth` whole cells from the
/// isosurface (deep inside: a merge, deep outside: a split) or, with the plain test, all complex
/// cells; and cells at a node whose winding is above 1 (self-intersection: a merge) or below 0
/// (inverted: a split). Sorted by id, each once; `marked` counts them by first cause.
std::vector<LatticeId> find_events(const CellSet& set, const Winding& winding,
                                   const EventTest& test, MarkedCells& marked);

}  // namespace suture::surgery
