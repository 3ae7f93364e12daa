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

/// The components to measure, and how finely.
struct BodyChoice {
  std::vector<std::uint32_t> which;  ///< as components() numbers them
  int most_lines = 48;  ///< across a body's longer side; there are fewer where bodies are many
};

/// Measures the components that are named, in that order. Points are taken along a regular grid of
/// lines across the component's largest projection, so that a sheet is measured as well as a ball;
/// both surfaces are asked for their winding there, exactly. Points that another body covers in
/// `before` (or, for a cavity, fills) are not the component's to lose. The error is that of the
/// sampling: about a hundredth for up to five round bodies, a tenth for thousands, which share some
/// 50,000 points. \pre both surfaces are closed, finite and oriented, and `before` is not empty
std::vector<BodyLoss> body_losses(const Triangles& before, const Triangles& after,
                                  const BodyChoice& choice);

/// The same for all components of `before`.
std::vector<BodyLoss> body_losses(const Triangles& before, const Triangles& after);

}  // namespace suture
