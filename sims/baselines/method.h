// Whichever baseline a method names, begun with a surface.
#pragma once

#include <memory>

#include "sims/baselines/method_options.h"
#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// The baseline that the method names, begun with `surface`. \throw InvalidInput if the method is a
/// mesh, or refuses its options or the surface
std::unique_ptr<SurfaceTracker> make_baseline(const Triangles& surface,
                                              const MethodOptions& method);

}  // namespace suture::sims
