// Triangles that face the same way as their neighbours, wherever that can be.
#pragma once

#include "kernel/triangles.h"

namespace suture {

struct TurnedTriangles {
  std::size_t triangles = 0;  ///< how many triangles were turned over
  std::size_t not_orientable =
      0;  ///< how many components, such as Klein bottles, cannot be oriented
};

/// Turns triangles over so that the two at an edge run along it in opposite ways, wherever just two
/// share it. In each component the fewer triangles are turned; of two equally large parts, the one
/// without its first triangle. Components that cannot be oriented stay as they are. Triangles with
/// indices out of range are passed over.
TurnedTriangles orient_consistently(Triangles& surface);

}  // namespace suture
