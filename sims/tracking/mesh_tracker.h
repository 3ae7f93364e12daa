// The mesh tracker behind the interface that its rivals have too.
#pragma once

#include <limits>
#include <memory>

#include "sims/tracking/surface_tracker.h"

namespace suture::sims {

inline constexpr int kWhenItSettles = std::numeric_limits<int>::max();  ///< and at no step

/// How often the mesh is looked after, in steps; 0: never, not even when it settles. Both 0 are the
/// paper's other extreme, markers on a mesh that never changes [§9].
struct MeshSchedule {
  int remodel_every = 1, improve_every = 1;
};

/// \throw InvalidInput as Tracker
std::unique_ptr<SurfaceTracker> make_mesh_tracker(Triangles surface, const TrackerOptions& options,
                                                  const MeshSchedule& schedule);

}  // namespace suture::sims
