// The checks that every shape makes of its parameters.
#pragma once

#include <cmath>
#include <string>

#include "kernel/errors.h"
#include "kernel/shapes/shapes.h"

namespace suture {

/// The values that a parameter may have, both ends included, and the same in words.
struct AllowedRange {
  double low, high;
  std::string words;
};

/// \throw InvalidInput unless the value is in the range, as NaN never is
inline void require_range(const std::string& name, double value, const AllowedRange& range) {
  if (std::isfinite(value) && value >= range.low && value <= range.high) return;
  throw InvalidInput(name + " is " + number(value) + "; it must be " + range.words);
}

/// \throw InvalidInput unless the value is a length whose powers are in the range of doubles
inline void require_positive(const std::string& name, double value) {
  require_range(name, value, {1e-150, 1e150, "a finite positive length (1e-150 to 1e150)"});
}

/// \throw InvalidInput unless the edge length is positive, and an area of that many squares of the
/// same unit then takes at most kMostTriangles triangles
inline void require_resolution(const std::string& shape, double area, double edge_length) {
  require_positive(shape + ": edge_length", edge_length);
  const double triangles = area / (std::sqrt(0.1875) * edge_length * edge_length);
  if (!(triangles <= kMostTriangles))
    throw InvalidInput(shape + ": edge_length " + number(edge_length) + " asks for more than " +
                       std::to_string(std::llround(kMostTriangles)) +
                       " triangles; choose a longer one");
}

/// A shape's thinnest parts, and the longest edges that still make them out.
struct ThinParts {
  const char* name;
  double radius = 0;
  double edge = 1;  ///< the longest edges, in radii
};

/// \throw InvalidInput where edges are longer
inline void require_thin_edges(const std::string& shape, double edge_length,
                               const ThinParts& parts) {
  const double longest = parts.edge * parts.radius;
  if (edge_length > longest)
    throw InvalidInput(shape + ": edge_length " + std::to_string(edge_length) +
                       " is too long for its " + parts.name + "; choose at most " +
                       number(parts.edge) + " of their radius, " + std::to_string(longest));
}

}  // namespace suture
