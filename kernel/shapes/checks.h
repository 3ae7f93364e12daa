// What every shape asks of its parameters.
#pragma once

#include <cmath>
#include <string>

#include "kernel/errors.h"
#include "kernel/shapes/shapes.h"

namespace suture {

/// \throw InvalidInput unless low <= value <= high (so not NaN either); `range` says it in words
inline void require_range(const std::string& name, double value, double low, double high,
                          const std::string& range) {
  if (std::isfinite(value) && value >= low && value <= high) return;
  throw InvalidInput(name + " is " + number(value) + "; it must be " + range);
}

inline void require_positive(const std::string& name, double value) {
  require_range(name, value, 1e-150, 1e150, "a finite positive length (1e-150 to 1e150)");
}

/// \throw InvalidInput unless the edge length is positive and the area then takes at most
/// kMostTriangles triangles
inline void require_resolution(const std::string& shape, double area, double edge_length) {
  require_positive(shape + ": edge_length", edge_length);
  const double triangles = area / (std::sqrt(0.1875) * edge_length * edge_length);
  if (!(triangles <= kMostTriangles))
    throw InvalidInput(shape + ": edge_length " + number(edge_length) + " asks for more than " +
                       std::to_string(std::llround(kMostTriangles)) +
                       " triangles; choose a longer one");
}

/// A shape's thinnest parts.
struct ThinParts {
  const char* name;
  double radius = 0;
  double share = 1;  ///< of the radius: the longest edges that still make them out
};
/// \throw InvalidInput where edges are longer
inline void require_thin_edges(const std::string& shape, double edge_length,
                               const ThinParts& parts) {
  const double longest = parts.share * parts.radius;
  if (edge_length > longest)
    throw InvalidInput(shape + ": edge_length " + std::to_string(edge_length) +
                       " is too long for its " + parts.name + "; choose at most " +
                       number(parts.share) + " of their radius, " + std::to_string(longest));
}

}  // namespace suture
