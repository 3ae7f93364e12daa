// The volume that is inside one surface and not the other, along lines that cross both.
#pragma once

#include "kernel/triangles.h"

namespace suture {

struct LineOptions {
  int lines = 256;  ///< along the longest side of the common bounding box, for each of three axes
};

/// What the lines found, in the scene's unit cubed.
struct SymmetricDifference {
  double volume = 0;
  double error = 0;       ///< standard error of `volume`, from what four quarters of the lines give
  double spacing = 0;     ///< between lines
  std::size_t lines = 0;  ///< that met a surface
  std::size_t skipped = 0;  ///< of them those along which a surface was not closed
};

/// Lines of a regular grid along each axis are cut by both surfaces, exactly but for rounding, and
/// the lengths on which only one of them has winding 1 or more are added up. So a difference much
/// thinner than the spacing is measured as well as a thick one: the error is a share of it. Each
/// place counts for the three axes by the normal of the nearest triangle of `a`, squared.
/// \pre indices in range, finite positions \throw InvalidInput unless there is a line at least
SymmetricDifference symmetric_difference(const Triangles& a, const Triangles& b,
                                         const LineOptions& options = {});

}  // namespace suture
