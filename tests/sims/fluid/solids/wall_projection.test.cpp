#include "sims/fluid/solids/wall_projection.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/random.h"
#include "tests/sims/fluid/liquids.h"

using namespace suture;
using namespace suture::sims;

namespace {

/// Projected, extrapolated and constrained.
MacVelocity slid(const LiquidScene& scene, const std::function<Point(const Point&)>& field) {
  MacVelocity v = scene.velocity(field);
  CHECK(project(v, scene.input()).converged());
  extrapolate(v, 3);
  constrain(v, scene.faces, SolidsAt(scene.solids, 0));
  return v;
}

}  // namespace

TEST_CASE("liquid slides along walls of the grid freely and does not cross them") {
  for (const double wall : {0.8, 0.83, 0.86}) {  // on a plane, and between two
    Solids walls{{Solid::container({{-3, -3, 0.8 - wall}, {3, wall, 3}})}};
    const LiquidScene scene(block_of_liquid({0, 0, 0.8 - wall}, {0.8, wall, 0.7}), 0.1, walls);
    const auto along = [](const Point&) -> Point { return {1, 0, 0}; };
    const MacVelocity v = slid(scene, along);
    for (const double x : {0.2, 0.45, 0.6})
      for (const double z : {0.8 - wall, 0.9 - wall, 0.5}) {
        CHECK((v.at({x, wall, z}) - Point(1, 0, 0)).norm() < 1e-5);
        CHECK((v.at({x, wall + 0.03, z}) - Point(1, 0, 0)).norm() < 1e-5);
      }
  }
}

TEST_CASE("whatever flows beside a wall, across it the velocity at its surface is the wall's") {
  SolidMotion motion;
  motion.velocity = Point(0, 0, 0.7);
  for (const double floor :
       {0.01, 0.03, 0.05, 0.1}) {  // the closed faces are up to half a cell deep
    Solids walls{{Solid::container({{-9, -9, floor}, {9, 9, 9}}, motion)}};
    const LiquidScene scene(block_of_liquid({0, 0, floor}, {0.8, 0.8, 0.7}), 0.1, walls);
    Random random(4);
    MacVelocity v = scene.velocity([&](const Point&) -> Point {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
      return {x, y, z};
    });
    for (auto& known : v.known) known.assign(known.size(), 1);
    constrain(v, scene.faces, SolidsAt(scene.solids, 0));
    for (int n = 0; n < 50; ++n) {
      const double x = random.uniform(0.1, 0.7), y = random.uniform(0.1, 0.7);
      CHECK(v.at({x, y, floor})[2] == Approx(0.7).margin(1e-12));
    }
  }
}

TEST_CASE("what falls on a wall has hardly a velocity across it there") {
  for (const double floor : {0.0, 0.03, 0.06, 0.09}) {
    Solids walls{{Solid::container({{0, 0, floor}, {0.8, 0.8, 3}})}};
    const LiquidScene scene(block_of_liquid({0, 0, floor}, {0.8, 0.8, 0.67}), 0.1, walls);
    // Squeezed from the sides' middle to the sides: -z and x.
    const MacVelocity v = slid(scene, [](const Point& p) -> Point {
      return {p[0] - 0.4, 0, -2 * p[2]};
    });
    for (const double x : {0.15, 0.35, 0.66})
      CHECK(std::abs(v.at({x, 0.4, floor})[2]) < 3e-4);  // 6e-5 measured; 0.2 a cell above
  }
}

TEST_CASE("liquid goes with a moving wall across it, and along it as it likes") {
  SolidMotion motion;
  motion.velocity = Point(0.5, 0, 9);
  Solids walls{{Solid::container({{0.03, 0, 0}, {3, 0.8, 0.8}}, motion)}};
  const LiquidScene scene(block_of_liquid({0.03, 0, 0}, {0.8, 0.8, 0.8}), 0.1, walls);
  const MacVelocity v = slid(scene, [](const Point&) -> Point { return {0.5, 0, 9}; });
  for (const double y : {0.25, 0.4, 0.63})
    CHECK((v.at({0.03, y, 0.4}) - Point(0.5, 0, 9)).norm() < 1e-4);
}

TEST_CASE("round a ball the velocity across is small, and smaller on a finer grid") {
  double before = 0;
  for (const double h : {0.1, 0.05}) {
    Solids walls{{Solid::ball({0, 0, 0}, 0.5)}};
    const LiquidScene scene(ball({0.03, 0.02, 0.01}, 1.4, h), h, walls);
    const MacVelocity v = slid(scene, [](const Point&) -> Point { return {1, 0, 0}; });
    Random random(1);
    double sum = 0;
    const int points = 300;
    for (int n = 0; n < points; ++n) {
      Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      p *= 0.5 / p.norm();
      sum += std::pow(v.at(p).dot(p) / 0.5, 2);
    }
    const double rms = std::sqrt(sum / points);
    CHECK(rms < h);  // 0.087 and 0.047 measured
    if (before > 0) CHECK(rms < 0.7 * before);
    before = rms;
  }
}

TEST_CASE("a point outside is kept outside, one inside comes out, and else nothing changes") {
  Solids solids{{Solid::container({{-2, -2, -2}, {2, 2, 2}}), Solid::ball({0, 0, 0}, 0.7),
                 Solid::box({{1, -1, -1}, {1.3, 1, 1}})}};
  Random random(2);
  int changed = 0;
  for (int n = 0; n < 2000; ++n) {
    Point p{random.uniform(-2.2, 2.2), random.uniform(-2.2, 2.2), random.uniform(-2.2, 2.2)};
    Point v{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
    const double dt = 0.1;
    if (solids.distance(p, 0) < -0.1) continue;
    const Point kept = WallProjection{solids, 0, dt, 0.1}.of_point(p, v);
    CHECK(solids.distance(p + kept * dt, 0) > -1e-7);  // -3e-9 measured
    if (kept == v) continue;
    ++changed;
  }
  CHECK(changed > 200);
  CHECK(WallProjection{solids, 0, 0.1, 0.1}.of_point({1.8, 0, 0}, {0.1, 3, 0}) == Point(0.1, 3, 0));
  const Point along = WallProjection{solids, 0, 0.1, 0.1}.of_point({1.95, 0, 0}, {2, 3, -1});
  CHECK((along - Point(0.5, 3, -1)).norm() < 1e-9);
  CHECK(WallProjection{{}, 0, 1, 1}.of_point({0, 0, 0}, {1, 2, 3}) == Point(1, 2, 3));
}

TEST_CASE("a fast point does not jump a thin wall, and a moving one carries it along") {
  Solids plate{{Solid::box({{-0.05, -9, -9}, {0.05, 9, 9}})}};
  const Point v = WallProjection{plate, 0, 0.1, 0.1}.of_point({-0.4, 0, 0}, {10, 1, 0});
  CHECK(-0.4 + 0.1 * v[0] <= -0.05 + 1e-9);
  CHECK(v[1] == Approx(1));
  SolidMotion motion;
  motion.velocity = Point(2, 0, 0);
  Solids bar{{Solid::box({{-1, -9, -9}, {0, 9, 9}}, motion)}};
  CHECK(WallProjection{bar, 0, 0.1, 0.1}.of_point({0.01, 0, 0}, {0, 1, 0})[0] == Approx(1.9));
}

TEST_CASE("a body is kept out of solids as one, and is told where they leave it no way") {
  const Solids floor{{Solid::container({{0, 0, 0}, {1, 1, 1}})}};
  const std::vector<Point> body{{0.5, 0.02, 0.5}, {0.5, 0.1, 0.5}, {0.6, 0.05, 0.5}};
  const BodyVelocity landed = WallProjection{floor, 0, 0.1, 0.1}.of_body(body, {1, -3, 0});
  CHECK((landed.velocity - Point(1, -0.2, 0)).norm() < 1e-12);
  CHECK_FALSE(landed.squeezed);
  const BodyVelocity cornered = WallProjection{floor, 0, 0.1, 0.1}.of_body(body, {9, -3, 0});
  CHECK((cornered.velocity - Point(4, -0.2, 0)).norm() < 1e-12);
  CHECK(WallProjection{floor, 0, 0.1, 0.1}.of_body(body, {0, 2, 0}).velocity == Point(0, 2, 0));
  SolidMotion down;
  down.velocity = {0, -1, 0};
  const Solids press{{floor.all[0], Solid::box({{-1, 0.12, -1}, {2, 9, 2}}, down)}};
  CHECK(WallProjection{press, 0, 0.1, 0.1}.of_body(body, {0, 0, 0}).squeezed);
}

TEST_CASE("a point that solids leave no way ends half way between their sides") {
  SolidMotion down;
  down.velocity = {0, -1, 0};
  const Solids press{
      {Solid::container({{0, 0, 0}, {1, 1, 1}}), Solid::box({{-1, 0.02, -1}, {2, 9, 2}}, down)}};
  for (const double y : {0.0, 0.01, 0.02}) {  // the press is at -0.08 by then
    const Point v = WallProjection{press, 0, 0.1, 0.1}.of_point({0.5, y, 0.5}, Point::Zero());
    CHECK(y + 0.1 * v[1] == Approx(-0.04).margin(1e-9));
  }
}
