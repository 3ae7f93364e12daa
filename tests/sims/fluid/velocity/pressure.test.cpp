#include "sims/fluid/velocity/pressure.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "kernel/errors.h"
#include "kernel/random.h"
#include "tests/sims/fluid/liquids.h"

using namespace suture;
using namespace suture::sims;

namespace {

Point swirl(const Point& p) {
  return {std::sin(3 * p[1]) + p[0] * p[2], std::cos(2 * p[0]) - p[1], p[0] * p[1] + 0.3 * p[2]};
}

/// One projection of still liquid after gravity for a time that lets it fall a tenth of a cell: the
/// largest velocity after, over √(g·depth).
double stirred(const LiquidScene& scene, double depth, const Point& down = {0, 0, -1}) {
  const double h = scene.grid.h(), g = 9.81, dt = std::sqrt(0.2 * h / g);
  MacVelocity v = scene.velocity([&](const Point&) -> Point { return g * dt * down; });
  SolverOptions options;
  options.tolerance = 1e-9;
  const SolveReport report = project(v, scene.input(dt, 1000), options);
  CHECK(report.residual <= 1e-9 * 1.1);
  return scene.largest(v) / std::sqrt(g * depth);
}

Solids tank(const Point& low, const Point& high) { return {{Solid::container({low, high})}}; }

}  // namespace

TEST_CASE("after projection what flows out of each cell is nothing, to the solver's tolerance") {
  Random random(1);
  for (int n = 0; n < 6; ++n) {
    CarvedBallParameters p;
    p.centre = Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    p.seed = n + 1;
    p.edge_length = 0.15;
    Solids walls;
    if (n % 2 == 1) {
      walls.all.push_back(Solid::ball(p.centre + Point(0.8, 0.1, -0.2), 0.6));
      walls.all.push_back(
          Solid::box({p.centre - Point(2, 2, 2), p.centre - Point(0.4, 0.1, 0.33)}));
      SolidMotion motion;
      motion.velocity = Point(0.3, -0.2, 0.5);
      walls.all.push_back(Solid::ball(p.centre - Point(-0.1, 0.7, 0.2), 0.3, motion));
    }
    const LiquidScene scene(carved_ball(p), 0.1, walls);
    MacVelocity v = scene.velocity(swirl);
    const double before = scene.outflows(v);
    const SolveReport report = project(v, scene.input());
    CHECK(report.residual <= 1e-6);
    CHECK(report.iterations < 30);
    CHECK(scene.outflows(v) < 1.5e-6 * before);
  }
}

TEST_CASE("still water in a tank stays still, whatever the height of its surface") {
  const double h = 0.1;
  for (const double height : {1.0, 1.02, 1.05, 1.0501, 1.07, 1.0999}) {
    const LiquidScene scene(block_of_liquid({0, 0, 0}, {0.8, 0.8, height}), h,
                            tank({0, 0, 0}, {0.8, 0.8, 3}));
    CHECK(stirred(scene, height) < 1e-6);  // 1e-9 measured
  }
}

TEST_CASE("still water stays still where walls are between the planes of the grid") {
  const double h = 0.1;
  for (const double wall : {0.83, 0.87})
    for (const double height : {1.01, 1.04, 1.06, 1.09}) {
      const Point low(-0.02, -0.06, -0.03), high(wall, wall + 0.04, 3);
      const LiquidScene scene(block_of_liquid(low, {high[0], high[1], height}), h, tank(low, high));
      CHECK(stirred(scene, height) < 1e-6);
    }
}

TEST_CASE("pressure of still water pulls along any axis") {
  for (int a = 0; a < 3; ++a)
    for (const int side : {-1, 1}) {
      Point low(0, 0, 0), high(0.8, 0.8, 0.8), down(0, 0, 0), open = low, top = high;
      down[a] = side;
      (side < 0 ? top : open)[a] += side * -0.37;  // the free side
      (side < 0 ? high : low)[a] += side * -3;
      const LiquidScene scene(block_of_liquid(open, top), 0.1, tank(low, high));
      CHECK(stirred(scene, 0.5, down) < 1e-6);
    }
}

TEST_CASE("a tank filled to the brim, and a sealed pocket, hold still under gravity") {
  const LiquidScene brim(block_of_liquid({0, 0, 0}, {0.8, 0.8, 0.8}), 0.1,
                         tank({0, 0, 0}, {0.8, 0.8, 0.8}));
  CHECK(stirred(brim, 0.8) < 1e-6);
  // A box of solid with a chamber in it, in the middle of a pool: the chamber's liquid is a part of
  // its own.
  Solids walls = tank({0, 0, 0}, {1.6, 1.6, 3});
  const double outer = 0.4, inner = 0.6;
  for (int a = 0; a < 3; ++a)
    for (const bool up : {false, true}) {
      Box slab{Point::Constant(outer), Point::Constant(1.6 - outer)};
      (up ? slab.low : slab.high)[a] = up ? 1.6 - inner : inner;
      walls.all.push_back(Solid::box(slab));
    }
  const LiquidScene chamber(block_of_liquid({0, 0, 0}, {1.6, 1.6, 1.43}), 0.1, walls);
  CHECK(stirred(chamber, 1.43) < 1e-6);
}

TEST_CASE("a sealed tank that is asked to swell, or pressed, stays finite") {
  SolidMotion press;
  press.velocity = Point(0, 0, -1);
  Solids walls = tank({0, 0, 0}, {0.8, 0.8, 2});
  walls.all.push_back(Solid::box({{-1, -1, 0.8}, {2, 2, 3}}, press));
  const LiquidScene scene(block_of_liquid({0, 0, 0}, {0.8, 0.8, 0.8}), 0.1, walls);
  MacVelocity v = scene.velocity([](const Point&) -> Point { return {0, 0, 0}; });
  const std::vector<double> swell(scene.grid.size(), 3);
  ProjectionInput input = scene.input();
  input.divergence = &swell;
  CHECK(project(v, input).residual <= 1e-6);
  CHECK(scene.largest(v) < 2);  // 1.25 measured; the press comes down as fast as 1
}

TEST_CASE("still water on a sloping floor stays still, up to its shore") {
  // A floor of slope 0.3 that leaves the water on one side.
  const double h = 0.1, height = 0.93;
  const auto floor = [](double x) { return 0.3 * x - 0.1; };
  const double shore = (height + 0.1) / 0.3;
  const Triangles ground{{{-1, -1, floor(-1)},
                          {-1, 3, floor(-1)},
                          {6, -1, floor(6)},
                          {6, 3, floor(6)},
                          {-1, -1, -2},
                          {-1, 3, -2},
                          {6, -1, -2},
                          {6, 3, -2}},
                         {{0, 2, 1},
                          {1, 2, 3},
                          {4, 5, 6},
                          {5, 7, 6},
                          {0, 4, 2},
                          {2, 4, 6},
                          {1, 3, 5},
                          {3, 7, 5},
                          {0, 1, 4},
                          {1, 5, 4},
                          {2, 6, 3},
                          {3, 6, 7}}};
  Solids walls{
      {Solid::container({{0, 0, -5}, {6, 0.8, 5}}), Solid::mesh(ground, {Point::Zero(), h})}};
  const Triangles water{
      {{0, 0, floor(0)},
       {0, 0.8, floor(0)},
       {0, 0, height},
       {0, 0.8, height},
       {shore, 0, height},
       {shore, 0.8, height}},
      {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}, {0, 4, 2}, {1, 3, 5}, {0, 1, 4}, {1, 5, 4}}};
  const LiquidScene scene(water, h, walls);
  CHECK(stirred(scene, height) < 1e-6);
}

TEST_CASE("still water in a round bowl, where its mesh leaves a sliver out, is stirred little") {
  const double radius = 1, level = 0.33, h = 0.1;
  Triangles bowl = ball({0, 0, 0}, radius, 0.04),
            block = block_of_liquid({-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5});
  for (Triangle& t : bowl.triangles) std::swap(t[0], t[1]);
  for (const Triangle& t : block.triangles) {
    const auto n = static_cast<std::uint32_t>(bowl.positions.size());
    for (const std::uint32_t v : t) bowl.positions.push_back(block.positions[v]);
    bowl.triangles.push_back({n, n + 1, n + 2});
  }
  const Solids walls{{Solid::mesh(bowl, {Point::Zero(), h})}};
  for (const double gap : {0.0, 0.01, 0.02}) {  // 1e-10, 0.013 and 0.027 measured
    Triangles water = ball({0, 0, 0}, radius - gap, 0.1);
    for (Point& p : water.positions) p[2] = std::min(p[2], level);
    const LiquidScene scene(water, h, walls);
    CHECK(stirred(scene, radius + level) < (gap == 0 ? 1e-6 : 2 * gap));
  }
}

TEST_CASE("the projection is symmetric in the energy of what moves, as its matrix is") {
  const Solids walls{{Solid::ball({0.5, 0, 0.1}, 0.6)}};
  const LiquidScene scene(ball({0.2, 0.1, 0.3}, 1, 0.1), 0.1, walls);
  Random random(3);
  const auto noise = [&](const Point&) -> Point {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    return {x, y, z};
  };
  const MacVelocity u = scene.velocity(noise), v = scene.velocity(noise);
  MacVelocity pu = u, pv = v;
  SolverOptions options;
  options.tolerance = 1e-11;
  CHECK(project(pu, scene.input(), options).converged());
  CHECK(project(pv, scene.input(), options).converged());
  double left = 0, right = 0, size = 0;
  for (int a = 0; a < 3; ++a)
    for (Slot s = 0; s < scene.grid.size(); ++s) {
      if (pu.known[a][s] == 0) continue;
      const Slot below = scene.grid.neighbour(s, a, -1);
      const bool surface = scene.liquid.inside(s) != scene.liquid.inside(below);
      const double share = surface ? std::max(1e-3, scene.liquid.way_to_surface(a, s)) : 1;
      const double mass = scene.faces.open_at(a, s) * share;
      left += mass * pu.u[a][s] * v.u[a][s];
      right += mass * u.u[a][s] * pv.u[a][s];
      size += mass;
    }
  CHECK(std::abs(left - right) < 1e-9 * size);
  CHECK(std::abs(left) > 1e-4 * size);  // 1e-3 measured
}

TEST_CASE("a ball that falls freely is not touched") {
  const LiquidScene scene(ball({0.2, 0.1, 0.3}, 1, 0.1), 0.1);
  MacVelocity v = scene.velocity([](const Point&) -> Point { return {0.1, -0.7, -3.3}; });
  const std::array<std::vector<double>, 3> before = v.u;
  CHECK(project(v, scene.input()).iterations == 0);
  CHECK((v.u == before));
}

TEST_CASE("the faces that are open and touch liquid are known afterwards, and no others") {
  Solids walls = tank({-0.63, -3, -3}, {3, 3, 3});
  const LiquidScene scene(ball({0.2, 0.1, 0.3}, 1, 0.1), 0.1, walls);
  MacVelocity v = scene.velocity(swirl);
  for (auto& known : v.known) known.assign(known.size(), 1);
  CHECK(project(v, scene.input()).converged());
  for (int a = 0; a < 3; ++a)
    for (Slot s = 0; s < scene.grid.size(); ++s) {
      const bool expected = scene.touches(a, s) && scene.faces.open_at(a, s) > 0;
      if ((v.known[a][s] != 0) != expected) FAIL("face " << a << " " << s);
    }
}

TEST_CASE("the pressure's jump in a ball is recovered, and moves nothing") {
  const double h = 0.1;
  const LiquidScene scene(ball({0.02, 0.03, 0.01}, 1, 0.05), h);
  std::array<std::vector<double>, 3> jump;
  for (auto& j : jump) j.assign(scene.grid.size(), 2 * 0.07 / 1);
  MacVelocity v = scene.velocity([](const Point&) -> Point { return {0, 0, 0}; });
  ProjectionInput input = scene.input(0.01, 1000);
  input.jump = &jump;
  CHECK(project(v, input).residual <= 1e-6);
  const double unit = 0.01 * 2 * 0.07 / (1000 * h);  // the velocity of one jump over one cell
  CHECK(scene.largest(v) / unit < 1e-5);
}

TEST_CASE("liquid under a jump on one side is pushed as its gradient says") {
  // A bar along x in a tube, with pressure J on its left end and none on its right one.
  Solids walls = tank({-9, 0, 0}, {9, 0.4, 0.4});
  const LiquidScene scene(block_of_liquid({-1.03, 0, 0}, {0.98, 0.4, 0.4}), 0.1, walls);
  std::array<std::vector<double>, 3> jump;
  for (auto& j : jump) j.assign(scene.grid.size(), 0);
  for (Slot s = 0; s < scene.grid.size(); ++s)
    if (scene.grid.cell(s)[0] < 0) jump[0][s] = 5;
  MacVelocity v = scene.velocity([](const Point&) -> Point { return {0, 0, 0}; });
  ProjectionInput input = scene.input(0.1, 2);
  input.jump = &jump;
  CHECK(project(v, input).converged());
  const double expected = 0.1 / 2 * 5 / 2.01;
  for (Slot s = 0; s < scene.grid.size(); ++s)
    if (v.known[0][s] != 0) CHECK(v.u[0][s] == Approx(expected).epsilon(1e-5));
}

TEST_CASE("the wanted divergence is what flows out") {
  const LiquidScene scene(ball({0, 0, 0}, 1, 0.1), 0.1);
  const std::vector<double> wanted(scene.grid.size(), 0.3);
  MacVelocity v = scene.velocity([](const Point&) -> Point { return {0, 0, 0}; });
  ProjectionInput input = scene.input();
  input.divergence = &wanted;
  CHECK(project(v, input).converged());
  for (Slot s = 0; s < scene.grid.size(); ++s)
    if (scene.liquid.inside(s)) CHECK(scene.outflow(v, s) == Approx(0.03).epsilon(1e-3));
}

TEST_CASE("a drop without a cell keeps its velocity, and no liquid is no work") {
  const LiquidScene drop(ball({0.04, 0, 0}, 0.04, 0.02), 0.1);
  REQUIRE(drop.cells.droplets.size() == 1);
  MacVelocity v = drop.velocity([](const Point&) -> Point { return {1, 2, 3}; });
  for (auto& known : v.known) known.assign(known.size(), 1);
  CHECK(project(v, drop.input()).iterations == 0);
  CHECK((v.at({0.04, 0, 0}) - Point(1, 2, 3)).norm() < 1e-12);
  CHECK(v.at({0.5, 0, 0}) == Point(0, 0, 0));
}

TEST_CASE("a projection of what is not finite, or of another grid, is refused") {
  const LiquidScene scene(ball({0, 0, 0}, 0.3, 0.1), 0.1), other(ball({0, 0, 0}, 1, 0.1), 0.1);
  MacVelocity v = scene.velocity(swirl);
  CHECK_THROWS_AS(project(v, other.input()), InvalidInput);
  CHECK_THROWS_AS(project(v, scene.input(0)), InvalidInput);
  CHECK_THROWS_AS(project(v, scene.input(1, -1)), InvalidInput);
  v.u[1][scene.grid.find({0, 0, 0})] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(project(v, scene.input()), InvalidInput);
}
