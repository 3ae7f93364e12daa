// Whichever baseline a method names, begun with a surface.
#include "sims/baselines/method.h"

#include "kernel/errors.h"
#include "sims/baselines/contouring/semi_lagrangian_contouring.h"
#include "sims/baselines/level_set/level_set.h"
#include "sims/baselines/particle_level_set/particle_level_set.h"

namespace suture::sims {

std::unique_ptr<SurfaceTracker> make_baseline(const Triangles& surface,
                                              const MethodOptions& method) {
  switch (method.kind) {
    case MethodKind::level_set:
      return make_level_set_tracker(surface, method.level_set);
    case MethodKind::particle_level_set:
      return make_particle_level_set(surface, method.particle_level_set);
    case MethodKind::semi_lagrangian_contouring:
      return make_semi_lagrangian_contouring(surface, method.contouring);
    default:
      throw InvalidInput(std::string("the method \"") + method_name(method.kind) +
                         "\" is the tracker's own mesh and no baseline");
  }
}

}  // namespace suture::sims
