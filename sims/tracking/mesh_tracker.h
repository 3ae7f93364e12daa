// The mesh tracker behind the interface that the baselines have too.
#pragma once

#include <memory>

#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

/// A Tracker, which is remodelled and improved only when it is told to. If it never is, it is the
/// paper's other extreme, markers on a mesh that never changes [§9]. \throw InvalidInput as Tracker
std::unique_ptr<SurfaceTracker> make_mesh_tracker(Triangles surface, const TrackerOptions& options);

}  // namespace suture::sims
