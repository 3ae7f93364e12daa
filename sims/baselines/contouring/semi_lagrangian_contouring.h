// Semi-Lagrangian contouring: each step a new mesh, where the old mesh's distance is zero upstream.
#pragma once

#include <memory>

#include "sims/baselines/contouring/contouring_options.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// Starts as the mesh itself. Steps may be longer than cells.
/// \throw InvalidInput if an option is out of range; advect throws it where u is not finite, or
/// carries the surface so unevenly in one step that no band of nodes holds it
std::unique_ptr<SurfaceTracker> make_semi_lagrangian_contouring(const Triangles& surface,
                                                                const ContouringOptions& options);

}  // namespace suture::sims
