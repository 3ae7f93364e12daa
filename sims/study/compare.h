// Every measure of a surface against the exact one.
#pragma once

#include "sims/study/exact/truth.h"
#include "sims/study/table/row.h"

namespace suture::sims {

struct CompareOptions {
  std::size_t samples = 100000;  ///< on each surface, for distances
  int lines = 256;               ///< along the longest side, for the symmetric difference
};

/// Volume error and symmetric difference as parts of the exact volume, the latter with its standard
/// error; mean and largest distance both ways ("forth" is from the surface to the exact one);
/// how far points of the exact creases and corners are from the surface. Lengths are in the scene's
/// unit. An empty surface has a volume error of −1 and no distances.
Row compare(const Triangles& surface, const Truth& truth, const CompareOptions& options = {});

/// The mean and largest distance of the vertices from where the start's would exactly be. The cells
/// are empty unless the surface still has the start's triangles, so that its vertices are markers.
Row compare_markers(const Triangles& surface, const Triangles& start, const Carry& carry);

}  // namespace suture::sims
