// A scene run for a study.
#include "sims/study/scene_run.h"

#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

TEST_CASE("a run ends where the surface is as few components as was asked for") {
  Scene scene = parse_scene(
      "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 5, radius = 0.3 }\ncopies = 4\n"
      "scatter_high = [1, 0.4, 0.4]\n[motion]\nkind = \"normal_flow\"\n[tracker]\ncell_size = 0.1\n"
      "[time]\nstep = 0.05\nend = 2\n[measure]\nuntil_components = 1\nreference = \"none\"\n",
      "scene.toml");
  const SceneRun run = run_scene(scene, {2});
  REQUIRE(run.snapshots.size() == 1);
  CHECK(run.outcome == "done");
  CHECK(run.snapshots[0].time < 1);
  CHECK(components(run.snapshots[0].surface).count == 1);
}

TEST_CASE("a mesh that vanishes is measured as nothing at every time that was left") {
  Scene scene = parse_scene(
      "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 5, radius = 0.3 }\n"
      "[motion]\nkind = \"normal_flow\"\nspeed = -1\n[tracker]\ncell_size = 0.1\n"
      "[time]\nstep = 0.05\nend = 2\n[measure]\nreference = \"none\"\n",
      "scene.toml");
  const SceneRun run = run_scene(scene, {0, 1, 2});
  REQUIRE(run.snapshots.size() == 3);
  CHECK_THAT(run.failure, Contains("nothing was left"));
  CHECK_FALSE(run.snapshots[0].surface.triangles.empty());
  for (const int i : {1, 2}) {
    CHECK(run.snapshots[i].surface.triangles.empty());
    CHECK(run.snapshots[i].time == i);
  }
}
