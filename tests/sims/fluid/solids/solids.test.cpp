#include "sims/fluid/solids/solids.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "kernel/errors.h"
#include "kernel/measure/signed_distance.h"
#include "kernel/random.h"
#include "kernel/shapes/shapes.h"

using namespace suture;
using namespace suture::sims;

namespace {

Solids only(const Solid& solid) { return {{solid}}; }

Point random_point(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

}  // namespace

TEST_CASE("the distance of a mesh is exact at corners of the grid and close in between") {
  const double h = 0.25;
  const Point origin(0.01, 0.02, 0.03);
  SphereParameters p;
  p.radius = 1.5;
  p.edge_length = 0.2;
  const Triangles surface = sphere(p);
  const SignedDistance exact(surface);
  const Solid solid = Solid::mesh(surface, {origin, h});
  Random random(1);
  double most = 0;
  for (int n = 0; n < 3000; ++n) {
    Point q = random_point(random, 3);
    const double d = exact.at(q);
    if (std::abs(d) > (kSolidBand - 1) * h) {
      CHECK(solid.distance(q, 0) * d > 0);
      CHECK(std::abs(solid.distance(q, 0)) > (kSolidBand - 2) * h);
      continue;
    }
    most = std::max(most, std::abs(solid.distance(q, 0) - d));
    for (int a = 0; a < 3; ++a) q[a] = origin[a] + h * std::round((q[a] - origin[a]) / h);
    if (std::abs(exact.at(q)) < kSolidBand * h)
      CHECK(solid.distance(q, 0) == Approx(exact.at(q)).margin(1e-12));
  }
  CHECK(most < 0.1 * h);  // 0.075 measured
}

TEST_CASE("a solid moves as its motion says") {
  SolidMotion motion;
  motion.velocity = Point(1, 0, 0);
  motion.amplitude = Point(0, 0.5, 0);
  motion.period = 2;
  const Solid bar = Solid::box({{2, 2, 2}, {5, 5, 5}}, motion);
  for (const double t : {0.0, 0.3, 1.7}) {
    const Point moved(t, 0.5 * std::sin(std::numbers::pi * t), 0);
    CHECK(bar.distance(Point(5.5, 3, 3) + moved, t) == Approx(0.5));
    const double e = 1e-6;
    const Point slope = (motion.displacement(t + e) - motion.displacement(t - e)) / (2 * e);
    CHECK((bar.velocity(t) - slope).norm() < 1e-8);
    CHECK(bar.velocity(t).norm() <= bar.fastest());
  }
}

TEST_CASE("the nearest of several solids has its velocity, and no solid is infinitely far") {
  SolidMotion right;
  right.velocity = Point(2, 0, 0);
  Solids solids = only(Solid::ball({0, 0, 0}, 1, right));
  solids.all.push_back(Solid::container({{-5, -5, -5}, {5, 5, 5}}));
  CHECK(solids.distance({1.5, 0, 0}, 0) == Approx(0.5));
  CHECK(solids.distance({4.5, 0, 0}, 0) == Approx(0.5));
  CHECK(solids.velocity({1.5, 0, 0}, 0) == Point(2, 0, 0));
  CHECK(solids.velocity({4.5, 0, 0}, 0) == Point(0, 0, 0));
  CHECK((solids.normal({4.5, 0, 0}, 0, 1e-3) - Point(-1, 0, 0)).norm() < 1e-9);
  CHECK(Solids().distance({1, 2, 3}, 0) == std::numeric_limits<double>::infinity());
  CHECK(Solids().normal({1, 2, 3}, 0, 1) == Point(0, 0, 0));
}

TEST_CASE("solids of no size, or of numbers that are not finite, are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(Solid::box({{0, 0, 0}, {1, 0, 1}}), InvalidInput);
  CHECK_THROWS_AS(Solid::container({{0, 0, 0}, {1, nan, 1}}), InvalidInput);
  CHECK_THROWS_AS(Solid::ball({0, 0, 0}, 0), InvalidInput);
  CHECK_THROWS_AS(Solid::ball({0, nan, 0}, 1), InvalidInput);
  CHECK_THROWS_AS(Solid::mesh({}, {{0, 0, 0}, 1}), InvalidInput);
  SolidMotion motion;
  motion.period = 0;
  CHECK_THROWS_AS(Solid::ball({0, 0, 0}, 1, motion), InvalidInput);
}
