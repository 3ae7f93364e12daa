// A scene's method by its name, behind the one interface.
#include "sims/rivals/method.h"

#include "sims/rivals/mesh_tracker.h"

namespace suture {

bool keeps_a_mesh(const std::string& kind) {
  return kind == "mesh" || kind == "mesh_without_topology" || kind == "markers";
}

std::unique_ptr<SurfaceTracker> make_surface_tracker(const Scene& scene) {
  const std::string& kind = scene.method.kind;
  const bool topology = kind == "mesh", quality = kind != "markers";
  return make_mesh_tracker(scene.surface, scene.tracker,
                           {.remodel_every = topology ? scene.time.remodel_every : 0,
                            .improve_every = quality ? scene.time.improve_every : 0});
}

}  // namespace suture
