#include "kernel/shapes/shapes.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/measure/self_intersections.h"
#include "kernel/shapes/catalogue.h"

using namespace suture;

namespace {

constexpr double kPi = std::numbers::pi;

struct Case {
  std::string shape;
  std::vector<double> edge_lengths;  // coarse to fine
  double smallest_angle;             // degrees; each measured at these lengths, less a degree or so
  int euler;
};

// The sheet's angle is that of its rim where it is thinner than its edges: atan(0.02 / 0.2).
const std::vector<Case> kCases{
    {"sphere", {1, 0.3, 0.1, 0.03}, 53, 2}, {"box", {1, 0.3, 0.11, 0.03}, 26, 2},
    {"torus", {0.5, 0.2, 0.05}, 39, 0},     {"cylinder", {0.5, 0.2, 0.03}, 35, 2},
    {"zalesak", {10, 4, 1}, 27, 2},         {"dumbbell", {0.5, 0.1, 0.03}, 35, 2},
    {"sheet", {0.2, 0.05, 0.02}, 5, 2},     {"carved_ball", {0.3, 0.1, 0.03}, 3, 2},
    {"animal", {0.021, 0.014}, 16, 2},      {"hand", {0.016, 0.011}, 16, 2}};

double volume_of(const std::string& shape, double edge_length) {
  return volume(make_shape(shape, {{"edge_length", edge_length}}));
}

// Halving the edges brings a smooth body's volume at least three times closer to the exact one.
void check_convergence(const std::string& shape, double edge_length, double exact) {
  INFO(shape);
  const double coarse = std::abs(volume_of(shape, edge_length) - exact);
  const double fine = std::abs(volume_of(shape, edge_length / 2) - exact);
  CHECK(fine < coarse / 3);
  CHECK(fine < 0.003 * exact);
}

double zalesak_volume(const ZalesakParameters& p) {
  constexpr int kSlices = 20000;
  const double width = p.slot_width / kSlices;
  double slot = 0;
  for (int i = 0; i < kSlices; ++i) {
    const double x = -p.slot_width / 2 + (i + 0.5) * width, r2 = p.radius * p.radius - x * x;
    const double part = kPi - std::acos(p.slot_top / std::sqrt(r2));
    slot += width * (r2 * part + p.slot_top * std::sqrt(r2 - p.slot_top * p.slot_top));
  }
  return 4 * kPi / 3 * std::pow(p.radius, 3) - slot;
}

double angle_between(const Point& a, const Point& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / kPi;
}

}  // namespace

TEST_CASE("a sphere may have the volume of its ball, whatever its resolution") {
  for (const double edge : {0.5, 0.1}) {
    const double exact = 4 * kPi / 3 * 8;
    const Triangles on = sphere({.radius = 2, .edge_length = edge});
    const Triangles outside = sphere({.radius = 2, .edge_length = edge, .exact_volume = 1});
    CHECK(volume(on) < 0.9995 * exact);
    CHECK(volume(outside) == Approx(exact).epsilon(1e-14));
    CHECK(on.triangles == outside.triangles);
  }
  CHECK_THROWS_AS(sphere({.exact_volume = 2}), InvalidInput);
}

TEST_CASE("every shape is a closed embedded manifold of the right topology at every resolution",
          "[slow]") {
  REQUIRE(kCases.size() == shape_catalogue().size());
  for (const Case& c : kCases)
    for (const double edge_length : c.edge_lengths) {
      const Triangles surface = make_shape(c.shape, {{"edge_length", edge_length}});
      const Audit found = audit(surface);
      INFO(c.shape << " with edges of " << edge_length << ": " << found.first);
      CHECK(found.closed_manifold());
      CHECK(found.isolated_vertices == 0);
      CHECK(euler_characteristic(surface) == c.euler);
      CHECK(components(surface).count == 1);
      CHECK(volume(surface) > 0);
      CHECK(angles(surface).smallest > c.smallest_angle);
      const double mean = edge_lengths(surface).mean;
      CHECK(mean > 0.25 * edge_length);  // shorter than asked for on a thin neck or rim
      CHECK(mean < 1.8 * edge_length);   // longer on the walls of grooves
      if (surface.triangles.size() > 20000) continue;
      const SelfIntersections met = self_intersections(surface);
      CHECK(met.pairs.empty());
      CHECK(met.without_area == 0);
    }
}

TEST_CASE("thin necks, bent sheets, low slots and other seeds are embedded manifolds too",
          "[slow]") {
  const std::vector<Triangles> all{
      make_shape("dumbbell", {{"neck_radius", 0.002}, {"edge_length", 0.2}}),
      make_shape("dumbbell", {{"fillet", 5}, {"distance", 6}, {"edge_length", 0.2}}),
      make_shape("sheet", {{"bend", 300}, {"thickness", 0.1}}),
      make_shape("sheet", {{"bend", -180}, {"edge_length", 0.1}}),
      make_shape("torus", {{"tube_radius", 0.95}}),
      make_shape("zalesak", {{"slot_top", -12}, {"edge_length", 2}}),
      make_shape("zalesak", {{"slot_top", 12}, {"slot_width", 15}, {"edge_length", 3}}),
      make_shape("zalesak", {{"slot_width", 0.15}, {"edge_length", 3}}),
      make_shape("carved_ball", {{"seed", 7}, {"depth", 0.6}, {"edge_length", 0.08}}),
      make_shape("animal", {{"leg_radius", 0.02}, {"edge_length", 0.012}}),
      make_shape("animal", {{"leg_radius", 0.06}, {"edge_length", 0.03}}),
      make_shape("hand", {{"finger_radius", 0.025}, {"edge_length", 0.011}}),
      make_shape("hand", {{"finger_radius", 0.05}, {"edge_length", 0.02}})};
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO("shape " << i << " of the list");
    CHECK(audit(all[i]).closed_manifold());
    CHECK(volume(all[i]) > 0);
    CHECK(components(all[i]).count == 1);
    CHECK(self_intersections(all[i]).pairs.empty());
  }
}

TEST_CASE("volumes converge to the exact ones") {
  check_convergence("sphere", 0.1, 4 * kPi / 3);
  check_convergence("torus", 0.1, 2 * kPi * kPi * 0.16);
  check_convergence("cylinder", 0.1, kPi * 0.25);
  check_convergence("zalesak", 2, zalesak_volume({}));
  CHECK(volume_of("box", 0.07) == Approx(1).epsilon(1e-13));
  CHECK(volume_of("sheet", 0.05) == Approx(0.04).epsilon(1e-13));
}

TEST_CASE("Zalesak's corners, walls and floor are exactly in their places") {
  for (const double edge_length : {7.0, 1.0, 0.6}) {
    const Triangles surface = zalesak({.edge_length = edge_length});
    const double z = std::sqrt(15.0 * 15 - 10 * 10 - 2.5 * 2.5);
    std::size_t corners = 0, on_sphere = 0, on_slot = 0;
    for (const Point& p : surface.positions) {
      const Point q = p - Point(50, 75, 50);
      const bool wall = p[0] == 47.5 || p[0] == 52.5, floor = p[1] == 85;
      const bool sphere = std::abs(q.norm() - 15) < 1e-13 * 75;
      if (wall && floor && std::abs(std::abs(q[2]) - z) < 1e-13 * 50) ++corners;
      on_sphere += sphere;
      on_slot += (wall && p[1] <= 85) || (floor && p[0] >= 47.5 && p[0] <= 52.5);
      CHECK((sphere || wall || floor));
    }
    CHECK(corners == 4);
    CHECK(on_sphere > 20);
    CHECK(on_slot > 8);
  }
}

TEST_CASE("each triangle of Zalesak's sphere lies in one face of it") {
  const Triangles surface = zalesak({.edge_length = 1});
  for (const Triangle& t : surface.triangles) {
    const Point &a = surface.positions[t[0]], &b = surface.positions[t[1]],
                &c = surface.positions[t[2]];
    const Point normal = (b - a).cross(c - a), out = (a + b + c) / 3 - Point(50, 75, 50);
    const bool wall = (a[0] == b[0] && b[0] == c[0]), floor = a[1] == b[1] && b[1] == c[1];
    if (wall) CHECK(normal[0] * out[0] < 0);
    if (floor) CHECK(normal[1] < 0);
    if (!wall && !floor) CHECK(angle_between(normal, out) < 6);  // half an edge seen from 15 away
  }
}

TEST_CASE("the carved ball is seen whole from its centre, and is carved deep") {
  const Triangles ball = carved_ball({.radius = 2, .depth = 0.3, .edge_length = 0.1});
  double shallow = 0, deep = 1e300;
  for (const Point& p : ball.positions) {
    shallow = std::max(shallow, p.norm());
    deep = std::min(deep, p.norm());
  }
  CHECK(shallow == Approx(2));
  CHECK(deep == Approx(1.4));
  for (const Triangle& t : ball.triangles)
    CHECK(ball.positions[t[0]].dot(ball.positions[t[1]].cross(ball.positions[t[2]])) > 0);
  CHECK(volume(ball) < 0.9 * 4 * kPi / 3 * 8);
}

TEST_CASE("the carved ball reaches the resolution of the paper's Figure 1", "[slow]") {
  const Triangles ball = carved_ball({.edge_length = 0.0083});
  CHECK(ball.triangles.size() > 400000);
  CHECK(audit(ball).closed_manifold());
}

TEST_CASE("the same parameters give the same bits, and another seed another ball", "[slow]") {
  for (const ShapeInfo& shape : shape_catalogue())
    if (shape.name != "animal" && shape.name != "hand")
      CHECK(make_shape(shape.name, {{"edge_length", 0.2}}) ==
            make_shape(shape.name, {{"edge_length", 0.2}}));
  for (const char* name : {"animal", "hand"}) CHECK(make_shape(name, {}) == make_shape(name, {}));
  CHECK(!(make_shape("carved_ball", {{"edge_length", 0.2}}) ==
          make_shape("carved_ball", {{"edge_length", 0.2}, {"seed", 2}})));
}
