// The fluid on any number of threads.
#include <catch2/catch.hpp>

#include "kernel/parallel.h"
#include "kernel/shapes/shapes.h"
#include "sims/baselines/level_set/level_set.h"
#include "sims/driver/driver.h"
#include "sims/fluid/fluid.h"
#include "sims/tracking/mesh_tracker.h"
#include "tests/sims/fluid/watched.h"

using namespace suture;
using namespace suture::sims;

namespace {

std::unique_ptr<SurfaceTracker> tracked(bool mesh, const Triangles& liquid, double cell) {
  const Point origin = Point(0.011, 0.013, 0.007) * cell;
  if (!mesh) {
    LevelSetOptions o;
    o.cell_size = cell;
    o.origin = origin;
    return make_level_set_tracker(liquid, o);
  }
  TrackerOptions o;
  o.cell_size = cell;
  o.origin = origin;
  o.quality.keep_features = false;
  return make_mesh_tracker(liquid, o);
}

Triangles dam_after(int frames, int threads, bool mesh) {
  const ThreadLimit most(threads);
  FluidOptions o = tank();
  o.volume_control.emplace();
  o.viscosity = 0.1;
  o.surface_tension = 0.07;
  Fluid fluid(o, [](const Point&) -> Point { return Point::Zero(); });
  const auto surface = tracked(mesh, column(), o.cell_size);
  Driver driver(*surface, fluid, {mesh ? 1 : 0, mesh ? 1 : 0, 1});
  StepWatcher nobody;
  for (int i = 1; i <= frames; ++i) driver.frame(0.05 * i, nobody);
  return surface->surface();
}

}  // namespace

TEST_CASE("a dam breaks to the same bits on one thread and on several") {
  for (const bool mesh : {true, false}) {
    const Triangles one = dam_after(6, 1, mesh), several = dam_after(6, 4, mesh);
    CAPTURE(mesh);
    CHECK(one.positions.size() > 100);
    CHECK(one.positions == several.positions);
    CHECK(one.triangles == several.triangles);
  }
}
