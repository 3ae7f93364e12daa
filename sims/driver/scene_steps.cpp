// A scene's surface on its way: what tracks it, what moves it, and the driver that steps both.
#include "sims/driver/scene_steps.h"

#include <algorithm>

#include "kernel/errors.h"
#include "kernel/measure/nearest_triangle.h"
#include "sims/fluid/fluid.h"
#include "sims/tracking/mesh_tracker.h"

namespace suture::sims {
namespace {

/// The scene's motions, one after another.
class Phases : public Simulator {
 public:
  explicit Phases(Scene& scene) : scene_(scene) {}

  void step(SurfaceTracker& surface, double dt) override {
    motion_at(surface.time()).step(surface, dt);
  }
  void surface_changed(const Triangles& surface,
                       const std::vector<std::uint32_t>& vertex_map) override {
    for (Phase& phase : scene_.phases) phase.motion->surface_changed(surface, vertex_map);
  }

 private:
  /// The motion of the step that begins at `time`: a phase is over if the step's middle is past it.
  Motion& motion_at(double time) {
    const double middle = time + 0.5 * scene_.time.step;
    for (Phase& phase : scene_.phases)
      if (middle < phase.until) return *phase.motion;
    return *scene_.phases.back().motion;
  }

  Scene& scene_;
};

/// Each place begins with the velocity of the body that is nearest.
Fluid::Initial initial_velocity(const Scene& scene) {
  const std::vector<Point>& v = scene.velocities;
  if (v.empty() || std::all_of(v.begin(), v.end(), [&](const Point& p) { return p == v.front(); }))
    return [all = v.empty() ? Point(Point::Zero()) : v.front()](const Point&) { return all; };
  auto nearest = std::make_shared<NearestTriangle>(scene.surface);
  return [nearest, &scene](const Point& p) {
    return scene.velocities[scene.surface.triangles[nearest->triangle(p)][0]];
  };
}

/// A mesh is looked after as often as `time` says. A baseline looks after itself, and ends a frame
/// at the end of the run, under a fluid as often as a mesh would be looked after.
Schedule schedule_of(const Scene& scene) {
  const TimeOptions& time = scene.time;
  Schedule schedule{0, 0, kLastFrame};
  if (scene.method.kind == MethodKind::mesh) schedule.remodel_every = time.remodel_every;
  if (scene.method.is_mesh() && scene.method.kind != MethodKind::markers)
    schedule.improve_every = time.improve_every;
  if (scene.fluid) schedule.end_every = std::max(time.remodel_every, time.improve_every);
  return schedule;
}

void require_fields(const Scene& scene) {
  for (const Phase& phase : scene.phases)
    if (phase.motion->field() == nullptr)
      throw InvalidInput(scene.file.string() + ": the motion \"" + phase.kind +
                         "\" moves the vertices of a mesh and is no velocity field, which the "
                         "method \"" +
                         method_name(scene.method.kind) +
                         "\" needs; choose another motion, or a mesh");
}

void require_same_frames(const Scene& scene) {
  const TimeOptions& time = scene.time;
  if (time.improve_every != 0 && time.remodel_every != 0 &&
      time.improve_every != time.remodel_every)
    throw InvalidInput(scene.file.string() +
                       ": time.improve_every must be as remodel_every, or 0: a fluid's surface is "
                       "looked after at the end of the same frames");
}

}  // namespace

std::unique_ptr<SurfaceTracker> make_surface_tracker(const Scene& scene) {
  if (scene.method.is_mesh()) return make_mesh_tracker(scene.surface, scene.tracker);
  require_fields(scene);
  return make_baseline(scene.surface, scene.method);
}

void require_moved_mesh(const Scene& scene) {
  if (scene.fluid)
    throw InvalidInput(scene.file.string() +
                       ": its surface is moved by a fluid, for which there is nothing exact to "
                       "compare with; run it by `suture run`");
  if (scene.method.kind != MethodKind::mesh)
    throw InvalidInput(scene.file.string() + ": the method \"" + method_name(scene.method.kind) +
                       "\" is no mesh as the tracker looks after it, which this needs; take the "
                       "table [method] out, or run the scene by `suture run`");
}

SceneSteps::SceneSteps(Scene& scene) : scene_(scene), tracker_(make_surface_tracker(scene)) {
  if (scene.fluid) {
    auto fluid = std::make_unique<Fluid>(*scene.fluid, initial_velocity(scene));
    fluid_ = fluid.get();
    simulator_ = std::move(fluid);
    require_same_frames(scene);
  } else {
    simulator_ = std::make_unique<Phases>(scene);
  }
  driver_ = std::make_unique<Driver>(*tracker_, *simulator_, schedule_of(scene));
}

SceneSteps::~SceneSteps() = default;

void SceneSteps::step(StepWatcher& watcher) {
  ++index_;
  const TimeOptions& time = scene_.time;
  const double end = std::min(static_cast<double>(index_) * time.step, time.end);
  driver_->frame(end, watcher, more() ? FrameIs::one_of_many : FrameIs::last);
}

}  // namespace suture::sims
