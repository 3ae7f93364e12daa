// The part of each body's volume that is no longer there in another surface.
#pragma once

#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// The loss of one component of a surface. A component that is inside out is a cavity, and what it
/// loses is the part of it that was empty and is now filled.
struct BodyLoss {
  std::uint32_t component;  ///< as components() numbers them
  double volume;            ///< of the component, signed, in cubes of the scene's unit
  double part;              ///< 0 to 1: the part of its volume that has changed sides
  Point centre;             ///< of its bounding box
};

/// Measures the components named, in that order. Points are taken along a regular grid of lines
/// across the component's largest projection, 48 to the longer side, so that a sheet is measured as
/// well as a ball; both surfaces are asked for their winding there, exactly. Points that another
/// body covers in `before` (or, for a cavity, fills) are not the component's to lose. The error is
/// that of the sampling: about a hundredth for a round body. \pre both surfaces are closed, finite
/// and oriented, and `before` is not empty
std::vector<BodyLoss> body_losses(const Triangles& before, const Triangles& after,
                                  const std::vector<std::uint32_t>& which);

/// The same for all components of `before`.
std::vector<BodyLoss> body_losses(const Triangles& before, const Triangles& after);

}  // namespace suture
