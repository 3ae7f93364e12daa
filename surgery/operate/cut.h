// The mesh cut along the region's boundary; the parts in the region are dropped [§6.1 steps 1, 2
// and 4].
#pragma once

#include <vector>

#include "surgery/operate/sites.h"

namespace suture::surgery {

/// The triangles to take out of the old mesh, and those that replace the parts of them that are
/// kept.
struct CutMesh {
  std::vector<std::uint32_t> touched;  ///< triangles to remove, in order
  std::vector<Triangle> kept;          ///< sites: the touched triangles' parts outside the region
  std::vector<Arc> boundary;           ///< on the region's boundary
  std::size_t split_triangles = 0;     ///< of the touched, those kept cell by cell
  std::vector<std::uint32_t> whole;    ///< of the touched, those in the region as they are
  std::vector<Triangle> dropped;       ///< sites: the other parts in the region, if asked for
};

/// Whether a cut triangle's pieces are merged into polygons.
enum class Pieces {
  merged,  ///< where that is safe: few new triangles, proved only up to rounded orientation tests
  cell_by_cell  ///< one polygon a cell, everywhere: proved without any rounding
};

/// Whether the parts in the region are made too, for a collapse before they are dropped.
enum class Inside { dropped, made };

struct CutOptions {
  Pieces pieces = Pieces::merged;
  Inside inside = Inside::dropped;
};

/// Cuts the mesh of the findings that the sites belong to. \throw InternalFailure as
/// triangle_pieces
CutMesh cut(const CutOptions& options, Sites& sites);

}  // namespace suture::surgery
