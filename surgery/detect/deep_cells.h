// Some complex cells call for a change of topology: those of events [§5.3].
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

/// The cells at which topology changes, sorted by id, each once; and their number by first cause.
struct EventCells {
  std::vector<LatticeId> cells;
  MarkedCells marked;
};

/// Topology changes at complex cells at least `depth` whole cells from the isosurface (deep inside:
/// a merge, deep outside: a split) or, with the plain test, at all complex cells; and at cells with
/// a node whose winding is above 1 (self-intersection: a merge) or below 0 (inverted: a split).
EventCells find_events(const CellSet& set, const Winding& winding, const EventTest& test);

}  // namespace suture::surgery
