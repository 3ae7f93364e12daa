// One pass over crossings marks what holds mesh; one over crossed edges marks what is complex
// [§5.2].
#include "surgery/detect/complex_cells.h"

#include <algorithm>

namespace suture::surgery {

namespace {

void find_surface_cells(const Crossings& crossings, SparseField<SurfaceCell>& cells) {
  LatticeId last = ~LatticeId{0};  // neighbours in memory are mostly neighbours in space
  for (const Index3& cell : crossings.vertex_cell) {
    const LatticeId id = pack(cell);
    if (id != last) cells.index(id);
    last = id;
  }
  for (const FaceStep& s : crossings.edge_crossings) {
    cells.index(s.face);
    cells.index(step(s.face, s.axis, -1));
  }
}

void mark_face(CellSet& set, int axis, LatticeId face) {
  set.complex_faces[axis].index(face);
  set.cells[face].complex = true;
  set.cells[step(face, axis, -1)].complex = true;
}

}  // namespace

std::size_t CellSet::complex_count() const {
  return static_cast<std::size_t>(std::count_if(cells.values().begin(), cells.values().end(),
                                                [](const SurfaceCell& c) { return c.complex; }));
}

CellSet find_complex_cells(const Crossings& crossings, const Winding& winding) {
  CellSet set;
  find_surface_cells(crossings, set.cells);
  for (int axis = 0; axis < 3; ++axis) {
    const int b = next_axis(axis), c = prev_axis(axis);
    for (const CrossedEdge& e : winding.edges(axis)) {
      const bool complex = e.complex(), mixed = e.changes_side();
      cells_round_edge(e.edge, axis, [&](LatticeId cell) {
        SurfaceCell& info = set.cells[cell];
        info.mixed |= mixed;
        info.complex |= complex;
      });
      if (!complex) continue;
      mark_face(set, b, e.edge);
      mark_face(set, b, step(e.edge, c, -1));
      mark_face(set, c, e.edge);
      mark_face(set, c, step(e.edge, b, -1));
    }
    for (const LatticeId face : crossings.loop_faces[axis]) mark_face(set, axis, face);
  }
  for (SurfaceCell& cell : set.cells.values()) cell.complex |= !cell.mixed;
  return set;
}

}  // namespace suture::surgery
