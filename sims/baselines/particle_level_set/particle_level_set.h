// The particle level set: a level set that its particles correct [Enright et al. 2002,
// 2005].
#pragma once

#include <memory>

#include "sims/baselines/particle_level_set/particle_level_set_options.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// A tracker that starts as `surface`. Needs some 40 bytes a node of the bounding box, which
/// particles that have escaped for good can stretch, and 80 a particle. One thread, but for
/// OpenVDB's part. \throw InvalidInput unless `surface` is a closed mesh of finite points, the
/// options are in range and the grid fits its indices; its advect throws it where u is not finite
std::unique_ptr<SurfaceTracker> make_particle_level_set(const Triangles& surface,
                                                        const ParticleLevelSetOptions& options);

}  // namespace suture::sims
