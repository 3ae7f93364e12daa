#include "sims/driver/scene_steps.h"

#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/parallel.h"
#include "sims/driver/run.h"
#include "sims/scene/scene.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

namespace {

const char* const kAll[] = {"mesh",      "mesh_without_topology", "markers",
                            "level_set", "particle_level_set",    "semi_lagrangian_contouring"};

std::string text(const std::string& method, const std::string& motion = "kind = \"rotation\"") {
  return "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 6, x = 0.4 }\n[motion]\n" +
         motion + "\n[tracker]\ncell_size = 0.25\norigin = [0.1, 0.2, 0.3]\n[method]\n" + method +
         "\n[time]\nstep = 0.1\nend = 0.5\n";
}

Scene scene_of(const std::string& toml) { return parse_scene(toml, "scene.toml"); }

std::string kind(const std::string& name) { return "kind = \"" + name + "\""; }

/// Surfaces after a few steps.
Triangles end_of(const std::string& name) {
  Scene scene = scene_of(text(kind(name)));
  SceneSteps steps(scene);
  StepWatcher nobody;
  while (steps.more()) steps.step(nobody);
  return steps.surface();
}

}  // namespace

TEST_CASE("a scene's method is one word, and each carries a ball round as a closed manifold") {
  for (const char* const name : kAll) {
    INFO(name);
    const Scene start = scene_of(text(kind(name)));
    CHECK(method_name(start.method.kind) == std::string(name));
    const Triangles end = end_of(name);
    CHECK(audit(end).closed_manifold());
    // Four cells a radius: contouring loses 8 %, the particle level set 19 %, the others 2 %.
    CHECK(volume(end) == Approx(volume(start.surface)).epsilon(0.25));
    CHECK(components(end).count == 1);
  }
  CHECK(scene_of(text("")).method.kind == MethodKind::mesh);
}

TEST_CASE("a method's surface is the same to the last bit on one thread and on many") {
  for (const char* const name : {"level_set", "particle_level_set", "semi_lagrangian_contouring"}) {
    INFO(name);
    const Triangles many = end_of(name);
    const ThreadLimit one(1);
    CHECK(same_bits(end_of(name), many));
  }
}

TEST_CASE("only meshes follow motions that are no velocity field") {
  for (const char* const name : kAll) {
    INFO(name);
    Scene scene = scene_of(text(kind(name), "kind = \"mean_curvature\""));
    if (scene.method.is_mesh())
      CHECK_NOTHROW(make_surface_tracker(scene));
    else
      CHECK_THROWS_WITH(make_surface_tracker(scene), Contains("velocity field"));
  }
}

TEST_CASE("what needs the tracker's mesh says so when a scene has another method") {
  Scene scene = scene_of(text(kind("level_set")));
  CHECK_THROWS_WITH(require_moved_mesh(scene), Contains("level_set"));
}

TEST_CASE("a scene of a baseline runs, and its report tells the method and its cost") {
  const Folder folder;
  Scene scene = scene_of(text(kind("level_set") + "\n[meshes]\nevery = 5"));
  const RunSummary summary = run(scene, folder / "out");
  CHECK(summary.steps == 5);
  CHECK(summary.audit.closed_manifold());
  CHECK(summary.meshes == 2);
  const std::string report = contents(folder / "out/report.json");
  CHECK_THAT(report, Contains("\"method\": \"level_set\"") && Contains("\"substeps\""));
}
