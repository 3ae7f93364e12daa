// The mesh cut along the region's boundary; what lies in the region is dropped [§6.1 steps 1, 2 and
// 4].
#pragma once

#include <vector>

#include "surgery/operate/sites.h"
#include "surgery/operate/triangle_pieces.h"

namespace suture::surgery {

/// A directed segment on face `face` of a region cell (2·axis, + 1 for the upper one), as the patch
/// in the cell has it: seen from outside the cell, the material is on its right.
struct Arc {
  LatticeId cell;
  int face;
  std::uint32_t from, to;  ///< sites
};

/// The old mesh without its touched triangles, and what replaces the parts of them that are kept.
struct CutMesh {
  std::vector<std::uint32_t> touched;  ///< triangles to remove, in order
  std::vector<Triangle> kept;          ///< sites: the touched triangles' parts outside the region
  std::vector<Arc> boundary;           ///< on the region's boundary
  std::size_t split_triangles = 0;     ///< of the touched, those kept cell by cell
  std::vector<std::uint32_t> whole;    ///< of the touched, those in the region as they are
  std::vector<Triangle> dropped;       ///< sites: the other parts in the region, if asked for
};

/// How far a cut triangle's pieces are merged into polygons.
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

struct CutInput {
  const Incidence& mesh;
  const Lattice& lattice;
  const Oracle& oracle;
  const Crossings& crossings;
  const Region& region;
};

/// \throw InternalFailure as triangle_pieces
CutMesh cut(const CutInput& input, const CutOptions& options, Sites& sites);

}  // namespace suture::surgery
