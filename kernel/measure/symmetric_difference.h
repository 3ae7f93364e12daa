// The volume that is inside one surface and not the other, along lines that cross both.
#pragma once

#include "kernel/triangles.h"

namespace suture {

struct LineOptions {
  int lines = 256;  ///< lines that the longest side of the common bounding box holds, on each axis
};

/// The measured volume, in cubes of the scene's unit, and how it was found.
struct SymmetricDifference {
  double volume = 0;
  double error = 0;  ///< the standard error of `volume`, from what four quarters of the lines give
  double spacing = 0;       ///< the distance between lines
  std::size_t lines = 0;    ///< how many lines met a surface
  std::size_t skipped = 0;  ///< how many of those met one that was not closed along them
};

/// Cuts the lines of a regular grid along each axis by both surfaces, exactly but for rounding, and
/// adds up the lengths on which only one surface has winding 1 or more. A difference much thinner
/// than the spacing is so measured as well as a thick one: the error is a part of the volume. Each
/// place counts for an axis by the square of that component of the normal of the nearest triangle
/// of `a`. \pre indices in range, finite positions
/// \throw InvalidInput unless 1 to 100000 lines are asked for
SymmetricDifference symmetric_difference(const Triangles& a, const Triangles& b,
                                         const LineOptions& options = {});

}  // namespace suture
