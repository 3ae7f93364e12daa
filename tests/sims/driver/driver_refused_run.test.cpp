// A run in which surgeries are refused: what it keeps of them.
#include <catch2/catch.hpp>
#include <cmath>
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

/// Balls whose vertices are snapped to planes, lines and nodes of the lattice, where plain doubles
/// err.
Triangles refused_merge() {
  Triangles surface;
  for (const Point& centre : {Point(0, 0, 0), Point(0.4, 0, 0), Point(0.2, 0.4, 0)})
    add_ball(surface, 0.9, centre);
  for (Point& p : surface.positions)
    for (int a = 0; a < 3; ++a) p[a] = std::round(p[a] / 0.2) * 0.2;
  return surface;
}

}  // namespace

TEST_CASE("a run saves the surface of each refused surgery, and names it in its report") {
  const Folder folder;
  Scene scene = read_scene(folder.write(
      "scene.toml",
      "[[bodies]]\nshape = \"sphere\"\n[motion]\nkind = \"rest\"\n[tracker]\ncell_size = 0.2\n"
      "arithmetic = \"rounded\"\njitter = 0\n[time]\nstep = 1\nend = 2\nimprove_every = 0\n"));
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
