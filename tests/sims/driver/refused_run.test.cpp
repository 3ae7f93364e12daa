// A run in which surgeries are refused: what it keeps of them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "kernel/files.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/shapes/shapes.h"
#include "sims/driver/run.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

namespace {

void add_ball(Triangles& surface, double radius, const Point& centre) {
  const Triangles ball = sphere({centre, radius, 0.1, 6});
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  surface.positions.insert(surface.positions.end(), ball.positions.begin(), ball.positions.end());
  for (const Triangle& t : ball.triangles)
    surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Three balls that would merge, in an inverted one that must not.
Triangles refused_merge() {
  Triangles surface;
  add_ball(surface, 3, {0.01, 0.02, 0.03});
  for (Triangle& t : surface.triangles) std::swap(t[0], t[1]);
  for (const Point& centre :
       {Point(0.01, 0.02, 0.03), Point(0.41, 0.02, 0.03), Point(0.21, 0.32, 0.03)})
    add_ball(surface, 0.9, centre);
  return surface;
}

}  // namespace

TEST_CASE("a run saves the surface of each refused surgery, and names it in its report") {
  const Folder folder;
  Scene scene = read_scene(folder.write(
      "scene.toml",
      "[[bodies]]\nshape = \"sphere\"\n[motion]\nkind = \"rest\"\n[tracker]\ncell_size = 0.2\n"
      "events = \"merge\"\n[time]\nstep = 1\nend = 2\nimprove_every = 0\n"));
  scene.surface = refused_merge();
  const RunSummary summary = run(scene, folder / "out");
  CHECK(summary.refused == 2);
  const auto first = folder / "out" / "reproducers" / "refused_remodel_1.ply";
  const auto second = folder / "out" / "reproducers" / "refused_remodel_2.ply";
  CHECK(summary.reproducer == first.string());
  CHECK(read_triangles(first) == scene.surface);
  CHECK(read_triangles(second) == scene.surface);
  const auto report = nlohmann::json::parse(read_file(folder / "out" / "report.json"));
  REQUIRE(report["remodels"].size() == 2);
  CHECK(report["remodels"][0]["reproducer"] == first.string());
  CHECK(report["remodels"][1]["reproducer"] == second.string());
}
