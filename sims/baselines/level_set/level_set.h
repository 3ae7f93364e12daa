// The level set as OpenVDB keeps it: distances in a narrow band, moved by upwind or MacCormack
// steps.
#pragma once

#include <memory>

#include "sims/baselines/level_set/level_set_options.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// A level set that starts with exact distances. Velocities are taken at the middle of each
/// sub-step. \throw InvalidInput if an option is out of range or the surface does not fit the
/// lattice; advect throws it where u is not finite or leads farther than 2¹⁹ cells from the origin
std::unique_ptr<SurfaceTracker> make_level_set_tracker(const Triangles& surface,
                                                       const LevelSetOptions& options);

}  // namespace suture::sims
