// A scene's surface on its way: what tracks it, what moves it, and the driver that steps both.
#pragma once

#include <memory>

#include "sims/driver/driver.h"
#include "sims/scene/scene.h"

namespace suture::sims {

class Fluid;

/// The scene's surface as its method keeps it, at its start. \throw InvalidInput if a motion is no
/// velocity field and the method no mesh, or the method refuses its options or the surface
std::unique_ptr<SurfaceTracker> make_surface_tracker(const Scene& scene);

/// \throw InvalidInput unless motions move the scene's surface and its method is "mesh": for those
/// who compare with what is exact, or need the tracker itself
void require_moved_mesh(const Scene& scene);

/// Takes a scene's surface through its steps of `time.step` each. Keeps a reference to the scene,
/// whose motions move.
class SceneSteps {
 public:
  /// \throw InvalidInput as make_surface_tracker and Fluid; and where a fluid's surface would be
  /// remodelled and improved every few steps but not at the same ones
  explicit SceneSteps(Scene& scene);
  ~SceneSteps();

  std::int64_t count() const { return scene_.time.steps(); }  ///< steps from start to end
  /// Whether a step is left before the scene's end, whatever became of the surface.
  bool more() const { return index_ < count(); }
  /// The next step, which a fluid may cut into several. \pre more() \throw as Driver::frame
  void step(StepWatcher& watcher);
  /// The number of the last step that began, counted from 1; 0 before the first.
  std::int64_t index() const { return index_; }

  const Triangles& surface() const { return tracker_->surface(); }
  double time() const { return tracker_->time(); }
  TrackerCost cost() const { return tracker_->cost(); }
  /// Whether nothing is left to move: every part got thinner than a cell and split away.
  bool vanished() const { return surface().triangles.empty(); }
  const Fluid* fluid() const { return fluid_; }  ///< the mover of the surface; null: motions

 private:
  Scene& scene_;
  std::unique_ptr<SurfaceTracker> tracker_;
  std::unique_ptr<Simulator> simulator_;
  const Fluid* fluid_ = nullptr;
  std::unique_ptr<Driver> driver_;
  std::int64_t index_ = 0;
};

}  // namespace suture::sims
