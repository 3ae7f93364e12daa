#include "sims/baselines/method.h"

#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "sims/scene/scene.h"
#include "tests/sims/balls.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

namespace {

Scene scene_of(const std::string& method) {
  return parse_scene(
      "[[bodies]]\nshape = \"sphere\"\n[motion]\nkind = \"rotation\"\n[tracker]\n"
      "cell_size = 0.25\norigin = [0.1, 0.2, 0.3]\n[method]\n" +
          method + "\n[time]\nstep = 0.1\nend = 0.5\n",
      "scene.toml");
}

}  // namespace

TEST_CASE("a method takes its lattice from the tracker, and its own keys from its table") {
  const MethodOptions level_set =
      scene_of("kind = \"level_set\"\nadvection = \"mac_cormack\"\nrenormalise_every = 7").method;
  CHECK(level_set.level_set.cell_size == 0.25);
  CHECK(level_set.level_set.origin == Point(0.1, 0.2, 0.3));
  CHECK(level_set.level_set.advection == Advection::mac_cormack);
  CHECK(level_set.level_set.renormalise.every == 7);
  const MethodOptions contouring =
      scene_of("kind = \"semi_lagrangian_contouring\"\ncell_size = 0.5").method;
  CHECK(contouring.contouring.cell_size == 0.5);
}

TEST_CASE("a method's unknown words and keys are refused") {
  CHECK_THROWS_WITH(scene_of("kind = \"levelset\""), Contains("level_set"));
  CHECK_THROWS_WITH(scene_of("kind = \"mesh\"\ncell_size = 1"), Contains("cell_size"));
  CHECK_THROWS_WITH(scene_of("kind = \"level_set\"\nhalf_width = 0"), Contains("half_width"));
  CHECK_THROWS_WITH(scene_of("kind = \"semi_lagrangian_contouring\"\nhalf_width = 3"),
                    Contains("half_width"));
}

TEST_CASE("a mesh is no baseline") {
  for (const MethodKind kind :
       {MethodKind::mesh, MethodKind::mesh_without_topology, MethodKind::markers}) {
    MethodOptions method;
    method.kind = kind;
    CHECK_THROWS_WITH(make_baseline(subdivided_ball(1, 1), method), Contains(method_name(kind)));
  }
}

TEST_CASE("a baseline refuses what only a mesh can do, and is as it was") {
  for (const MethodKind kind : {MethodKind::level_set, MethodKind::particle_level_set,
                                MethodKind::semi_lagrangian_contouring}) {
    MethodOptions method;
    method.kind = kind;
    method.level_set.cell_size = method.particle_level_set.cell_size = method.contouring.cell_size =
        0.25;
    const auto tracker = make_baseline(subdivided_ball(3, 1), method);
    INFO(method_name(kind));
    const Triangles before = tracker->surface();
    CHECK_FALSE(tracker->keeps_triangles());
    CHECK_THROWS_WITH(tracker->displace(before.positions, 0.1), Contains("displaced"));
    CHECK_THROWS_WITH(tracker->remodel(), Contains("remodelled"));
    CHECK_THROWS_WITH(tracker->improve(), Contains("improved"));
    CHECK(same_bits(tracker->surface(), before));
    CHECK(tracker->time() == 0);
  }
}
