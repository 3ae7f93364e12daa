// What every shape asks of its parameters.
#pragma once

#include <cmath>
#include <string>

#include "kernel/errors.h"
#include "kernel/shapes.h"

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

}  // namespace suture
