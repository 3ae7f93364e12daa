// The ways to track a surface that a scene can name, with their options, and whichever it names.
#include "sims/baselines/method.h"

#include "kernel/errors.h"
#include "sims/scene/scene.h"
#include "sims/tracking/mesh_tracker.h"

namespace suture::sims {
namespace {

void require_fields(const Scene& scene) {
  for (const Phase& phase : scene.phases)
    if (phase.motion->field() == nullptr)
      throw InvalidInput(scene.file.string() + ": the motion \"" + phase.kind +
                         "\" moves the vertices of a mesh and is no velocity field, which the "
                         "method \"" +
                         method_name(scene.method.kind) +
                         "\" needs; choose another motion, or a mesh");
}

/// A fluid's frames end with settle; what happens within them is not the tracker's to know.
int schedule(const Scene& scene, int every) {
  return scene.fluid && every > 0 ? kWhenItSettles : every;
}

}  // namespace

std::unique_ptr<SurfaceTracker> make_surface_tracker(const Scene& scene) {
  const MethodOptions& method = scene.method;
  const int remodel = schedule(scene, scene.time.remodel_every);
  const int improve = schedule(scene, scene.time.improve_every);
  if (!method.is_mesh()) require_fields(scene);
  switch (method.kind) {
    case MethodKind::level_set:
      return make_level_set_tracker(scene.surface, method.level_set);
    case MethodKind::particle_level_set:
      return make_particle_level_set(scene.surface, method.particle_level_set);
    case MethodKind::semi_lagrangian_contouring:
      return make_semi_lagrangian_contouring(scene.surface, method.contouring);
    case MethodKind::markers:
      return make_mesh_tracker(scene.surface, scene.tracker, {0, 0});
    case MethodKind::mesh_without_topology:
      return make_mesh_tracker(scene.surface, scene.tracker, {0, improve});
    case MethodKind::mesh:
      break;
  }
  return make_mesh_tracker(scene.surface, scene.tracker, {remodel, improve});
}

}  // namespace suture::sims
