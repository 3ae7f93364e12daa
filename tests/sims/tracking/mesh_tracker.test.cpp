#include "sims/tracking/mesh_tracker.h"

#include <catch2/catch.hpp>
#include <map>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "sims/flows/fields.h"
#include "tests/sims/balls.h"

using namespace suture;
using namespace suture::sims;

namespace {

std::map<std::string, double> counts(const SurfaceTracker& tracker) {
  const TrackerCost cost = tracker.cost();
  return {cost.counts.begin(), cost.counts.end()};
}

}  // namespace

TEST_CASE("a mesh that nobody looks after is carried by RK4 and nothing else") {
  const Triangles ball = subdivided_ball(3, 1);
  const auto mesh = make_mesh_tracker(ball, {.cell_size = 0.2});
  Tracker plain(ball, {.cell_size = 0.2});
  const VelocityField u = rotation({.rate = 1});
  for (int i = 0; i < 5; ++i) {
    mesh->advect(u, 0.1);
    plain.advect(u, 0.1);
  }
  mesh->end_of_frame();
  CHECK(same_bits(mesh->surface(), plain.surface()));
  CHECK(mesh->time() == plain.time());
  CHECK(counts(*mesh)["remodels"] == 0);
}

TEST_CASE("a mesh tracker does as a bare tracker when it is told to, and counts what it did") {
  const Triangles start = beside(subdivided_ball(3, 1), subdivided_ball(3, 1), {3, 0, 0});
  const auto mesh = make_mesh_tracker(start, {.cell_size = 0.1});
  Tracker plain(start, {.cell_size = 0.1});
  const VelocityField together = [](const Point& p, double) {
    return Point(p[0] > 1.5 ? -1.0 : 1.0, 0, 0);
  };
  for (int i = 0; i < 4; ++i) {
    mesh->advect(together, 0.16);
    plain.advect(together, 0.16);
  }
  CHECK(mesh->remodel().vertex_map == plain.remodel().vertex_map);
  CHECK(mesh->improve().vertex_map == plain.improve().vertex_map);
  CHECK(same_bits(mesh->surface(), plain.surface()));
  CHECK(components(mesh->surface()).count == 1);
  CHECK(counts(*mesh)["remodels"] == 1);
  CHECK(counts(*mesh)["surgeries_committed"] == 1);
  CHECK(counts(*mesh)["cells_resampled"] > 0);
}

TEST_CASE("distances to a mesh are those of the surface as it is now") {
  const auto mesh = make_mesh_tracker(subdivided_ball(4, 1), {.cell_size = 0.2});
  CHECK(mesh->distance({0, 0, 0}) == Approx(-1).margin(0.01));
  mesh->advect([](const Point&, double) { return Point(2, 0, 0); }, 1);
  CHECK(mesh->distance({2, 0, 0}) == Approx(-1).margin(0.01));
  std::vector<Point> back = subdivided_ball(4, 1).positions;
  mesh->displace(back);
  CHECK(mesh->distance({2, 0, 0}) == Approx(1).margin(0.01));
  CHECK(mesh->time() == 1);
}

TEST_CASE("a mesh of which nothing is left stays empty while time goes on, and refuses the rest") {
  // A disc thinner than a cell: the first remodel splits all of it away.
  Triangles disc = subdivided_ball(3, 1);
  for (Point& p : disc.positions) p[2] = 0.45 + 0.01 * p[2];
  const auto mesh = make_mesh_tracker(disc, {.cell_size = 0.3});
  const VelocityField rest = [](const Point&, double) { return Point(0, 0, 0); };
  mesh->advect(rest, 0.5);
  mesh->remodel();
  REQUIRE(mesh->surface().triangles.empty());
  mesh->advect(rest, 0.5);
  mesh->displace({}, 0.5);
  mesh->end_of_frame();
  CHECK(mesh->surface().triangles.empty());
  CHECK(mesh->time() == 1.5);
  CHECK_THROWS_AS(mesh->displace({Point(0, 0, 0)}, 1), InvalidInput);
  CHECK_THROWS_AS(mesh->remodel(), InvalidInput);
  CHECK_THROWS_AS(mesh->improve(), InvalidInput);
  CHECK(mesh->time() == 1.5);
}
