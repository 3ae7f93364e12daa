// A scene's method by its name, behind the one interface.
#pragma once

#include <memory>
#include <string>

#include "sims/rivals/surface_tracker.h"
#include "sims/scene.h"

namespace suture {

/// Whether the method of this name keeps a mesh of its own, which costs nothing to ask for.
bool keeps_a_mesh(const std::string& kind);

/// \throw InvalidInput as Tracker
std::unique_ptr<SurfaceTracker> make_surface_tracker(const Scene& scene);

}  // namespace suture
