// Complex edges, faces and cells: where the mesh is more than one sheet of isosurface could be
// [§5.2].
#pragma once

#include <array>

#include "surgery/detect/crossings.h"
#include "surgery/detect/winding.h"

namespace suture::surgery {

/// A cell that holds mesh, as detection sees it.
struct SurfaceCell {
  bool mixed = false;  ///< its corners do not share a side: the isosurface of D passes through it
  bool complex =
      false;  ///< has a complex edge or face, or holds mesh though its corners share a side
};

/// The cells that hold mesh, and the complex faces among theirs.
struct CellSet {
  SparseField<SurfaceCell> cells;                  ///< by the cell's lowest node
  std::array<SparseField<char>, 3> complex_faces;  ///< by axis; membership is all that counts
  std::size_t complex_count() const;
};

/// A complex edge has more than one crossing, or one that does not part inside from outside. A
/// complex face touches a complex edge or holds a closed loop of mesh ∩ face. \throw nothing
CellSet find_complex_cells(const Crossings& crossings, const Winding& winding);

}  // namespace suture::surgery
