// Exact references, against shapes and flows whose images are known by formula.
#include "sims/study/exact/exact_flow.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measure/measures.h"

using namespace suture;
using namespace suture::sims;

namespace {

Scene scene_of(const std::string& body, const std::string& motion) {
  return parse_scene("[[bodies]]\n" + body + "\n[motion]\n" + motion +
                         "\n[tracker]\ncell_size = 1\n[time]\nstep = 0.1\nend = 1\n",
                     "scene.toml");
}

const char* const kBall =
    "shape = \"sphere\"\nparameters = { radius = 0.15, edge_length = 0.1, "
    "x = 0.35, y = 0.35, z = 0.35 }";
const char* const kSlotted = "shape = \"zalesak\"\nparameters = { edge_length = 2 }";
const char* const kEnright = "kind = \"enright\"";

}  // namespace

TEST_CASE("the analytic volumes are the limits of finer and finer meshes") {
  for (const char* body : {"sphere", "zalesak"}) {
    INFO(body);
    double last = 1;
    for (const char* edge : {"0.8", "0.4"}) {
      const Scene scene = scene_of("shape = \"" + std::string(body) +
                                       "\"\nparameters = { radius = 15, edge_length = " + edge +
                                       ", y = 75 }\nscale = 0.5\nrotate = 20",
                                   "kind = \"rest\"");
      const double off = std::abs(volume(scene.surface) / exact_shape(scene).volume - 1);
      CHECK(off < 0.35 * last);  // measured: a quarter for half the edge length
      last = off;
    }
    CHECK(last < 4e-4);
  }
}

TEST_CASE("a sphere carried by a turn stays within the tolerance of the sphere") {
  const Scene scene = scene_of(kBall, "kind = \"rotation\"\nrate = 2\ncentre = [0.1, 0.2, 0.3]");
  const ExactSurface r =
      exact_flow(exact_shape(scene), exact_carry(scene, 1, 1e-13), {.tolerance = 1e-4});
  const Point d = Point(0.25, 0.15, 0.05),
              centre(0.1 + std::cos(2.0) * d[0] - std::sin(2.0) * d[1],
                     0.2 + std::sin(2.0) * d[0] + std::cos(2.0) * d[1], 0.35);
  double worst = 0;
  for (const Point& p : r.surface.positions)
    worst = std::max(worst, std::abs((p - centre).norm() - 0.15));
  CHECK(worst < 1e-12);
  CHECK(r.max_error < 1.4e-4);  // a triangle's middle is a third further out than its edges'
  CHECK(r.mean_error > 1e-6);
  CHECK(audit(r.surface).closed_manifold());
  CHECK(r.creases.empty());
}

TEST_CASE("Enright's flow keeps the volume of a carried sphere, and brings it back") {
  const Scene scene = scene_of(kBall, kEnright);
  const ExactShape shape = exact_shape(scene);
  const double exact = 4 * std::numbers::pi / 3 * std::pow(0.15, 3);
  const ExactSurface half = exact_flow(shape, exact_carry(scene, 0.5, 1e-9), {.tolerance = 2e-4});
  CHECK(audit(half.surface).closed_manifold());
  CHECK(std::abs(volume(half.surface) / exact - 1) < 2e-3);  // measured: 1.3e-3
  CHECK(half.max_error < 4e-4);
  const Carry back = exact_carry(scene, 3, 1e-13);
  for (const Point& p : {Point(0.35, 0.35, 0.5), Point(0.2, 0.35, 0.35), Point(0.35, 0.5, 0.35)})
    CHECK((back(p) - p).norm() < 1e-10);
}

TEST_CASE("the creases and corners of Zalesak's sphere are where the slot was cut") {
  const Scene scene = scene_of(kSlotted, "kind = \"translation\"\nvelocity = [1, 0, 0]");
  const ExactSurface r =
      exact_flow(exact_shape(scene), exact_carry(scene, 1, 1e-12), {.tolerance = 0.01});
  CHECK(audit(r.surface).closed_manifold());
  REQUIRE(r.corners.size() == 4);
  const double z = std::sqrt(15.0 * 15 - 10 * 10 - 2.5 * 2.5);
  for (const std::uint32_t v : r.corners) {
    const Point p = r.surface.positions[v];
    CHECK(std::abs(std::abs(p[0] - 51) - 2.5) < 1e-12);
    CHECK(std::abs(p[1] - 85) < 1e-12);
    CHECK(std::abs(std::abs(p[2] - 50) - z) < 1e-12);
  }
  double length = 0;
  for (const auto& [a, b] : r.creases)
    length += (r.surface.positions[a] - r.surface.positions[b]).norm();
  // Two circles of radius √(15² − 2.5²) less their arcs above the floor, the floor's two chords of
  // each, and its two arcs on the sphere.
  const double circle = std::sqrt(15.0 * 15 - 2.5 * 2.5), start = std::acos(10 / circle);
  const double arc = std::sqrt(15.0 * 15 - 10 * 10);
  const double exact =
      2 * circle * 2 * (std::numbers::pi - start) + 2 * 2 * z + 2 * arc * 2 * std::asin(2.5 / arc);
  CHECK(length == Approx(exact).epsilon(1e-3));
}

TEST_CASE("a polyhedron is carried as its mesh is, and edges are cut where the flow bends them") {
  const Scene scene = scene_of(
      "shape = \"box\"\nparameters = { size_x = 0.3, size_y = 0.3, size_z = "
      "0.3, edge_length = 0.3, x = 0.35, y = 0.35, z = 0.35 }",
      kEnright);
  const ExactShape shape = exact_shape(scene);
  CHECK_FALSE(shape.exact);
  const ExactSurface still = exact_flow(shape, exact_carry(scene, 0, 1e-9), {.tolerance = 1e-3});
  CHECK(still.surface == scene.surface);
  const ExactSurface moved = exact_flow(shape, exact_carry(scene, 0.5, 1e-9), {.tolerance = 1e-3});
  CHECK(moved.surface.triangles.size() > 100);
  CHECK(volume(moved.surface) == Approx(0.027).epsilon(1e-2));
}

TEST_CASE("motions that depend on the surface, and tolerances that take too much, are refused") {
  const Scene scene = scene_of(kBall, "kind = \"normal_flow\"");
  CHECK_THROWS_AS(exact_carry(scene, 1, 1e-9), InvalidInput);
  const Scene rest = scene_of(kBall, kEnright);
  const Carry carry = exact_carry(rest, 0.1, 1e-9);
  CHECK_THROWS_AS(exact_flow(exact_shape(rest), carry, {.tolerance = 0}), InvalidInput);
  CHECK_THROWS_AS(
      exact_flow(exact_shape(rest), carry, {.tolerance = 1e-6, .most_triangles = 20000}),
      InvalidInput);
}
