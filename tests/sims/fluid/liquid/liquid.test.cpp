#include "sims/fluid/liquid/liquid.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/shapes/transform.h"
#include "tests/sims/fluid/liquids.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("a cell is liquid where its centre is inside, and D is exact near the surface") {
  for (const double edge : {0.7, 4.0}) {  // in cells: finer and coarser than the grid
    const double h = 0.125;
    const LiquidScene scene(ball({0.31, -0.42, 0.17}, 1.2, edge * h), h, {}, {0.03, 0.01, 0.02});
    std::size_t inside = 0, exact = 0;
    for (Slot s = 0; s < scene.grid.size(); ++s) {
      const double d = scene.exact.at(scene.grid.centre(scene.grid.cell(s)));
      inside += scene.liquid.inside(s) ? 1 : 0;
      if ((d < 0) != scene.liquid.inside(s)) FAIL("cell " << s << " is on the other side");
      if (std::abs(d) > kNear * h) {
        if (std::abs(scene.liquid.distance[s]) < kNear * h) FAIL("far cell " << s << " is near");
        continue;
      }
      ++exact;
      if (d != scene.liquid.distance[s]) FAIL("near cell " << s << " has another D");
    }
    CHECK(static_cast<double>(inside) * h * h * h ==
          Approx(4.18879 * 1.2 * 1.2 * 1.2).epsilon(0.1));
    CHECK(exact > 2000);
  }
}

TEST_CASE("the grid has all cells within the band of the liquid") {
  const int band = 5;
  const LiquidScene scene(ball(Point::Zero(), 2.3, 0.4), 0.2, {}, {0.05, 0, 0.1}, band);
  int asked = 0;
  for (Slot s = 0; s < scene.grid.size(); ++s) {
    if (!scene.liquid.inside(s)) continue;
    ++asked;
    const Index3 c = scene.grid.cell(s);
    for (const int x : {-band, band})
      for (const int y : {-band, band})
        for (const int z : {-band, band})
          if (scene.grid.find({c[0] + x, c[1] + y, c[2] + z}) == kNoSlot) FAIL("no band at " << s);
  }
  CHECK(asked > 5000);
}

TEST_CASE("where the surface crosses between two centres is where it is, not what D suggests") {
  // A floor of liquid with a wall of liquid beside it: D of the cells at its edge is that to the
  // side.
  const LiquidScene scene(block_of_liquid({0, 0, 0}, {10, 10, 6.4}), 1);
  for (const Index3& c : {Index3{0, 0, 6}, Index3{5, 5, 6}, Index3{9, 3, 6}})
    CHECK(scene.liquid.way_to_surface(2, scene.grid.find(c)) == Approx(0.9).epsilon(1e-12));
  const LiquidScene turned(block_of_liquid({0, 0, -6.4}, {10, 10, 0}), 1);
  CHECK(turned.liquid.way_to_surface(2, turned.grid.find({0, 0, -6})) ==
        Approx(0.9).epsilon(1e-12));
}

TEST_CASE("a line through edges and vertices of the surface still crosses it") {
  // Vertices, edges and diagonals at centres of cells.
  BoxParameters p;
  p.centre = Point(4.5, 4.5, 4.5);
  p.size = Point(6, 6, 6.5);
  p.edge_length = 1;
  const LiquidScene scene(box(p), 1);
  int found = 0;
  for (Slot s = 0; s < scene.grid.size(); ++s)
    for (int a = 0; a < 3; ++a) {
      const Slot below = scene.grid.neighbour(s, a, -1);
      if (below == kNoSlot || scene.liquid.inside(s) == scene.liquid.inside(below)) continue;
      ++found;
      const double expected = a == 2 ? 0.25 : 1;
      if (std::abs(scene.liquid.way_to_surface(a, s) - expected) > 1e-12)
        FAIL("axis " << a << " has " << scene.liquid.way_to_surface(a, s));
    }
  CHECK(found == 2 * 25 + 4 * 5 * 7);
}

TEST_CASE("a drop that holds no cell's centre is told of, one that does is not") {
  const double h = 1;
  CHECK(LiquidScene(ball({0, 0, 0}, 0.4, 0.2), h).cells.droplets.size() == 1);
  CHECK(LiquidScene(ball({0.5, 0.5, 0.5}, 0.4, 0.2), h).cells.droplets.size() == 0);
  const LiquidScene scene(merged(std::vector{ball({0, 0, 0}, 0.4, 0.2), ball({12, 12, 12}, 5, 1)}),
                          h);
  CHECK(scene.cells.droplets.size() == 1);
  REQUIRE(scene.liquid.droplet_cells.size() == 8);
  for (const Slot s : scene.liquid.droplet_cells)
    for (const int i : scene.grid.cell(s)) CHECK((i == 0 || i == -1));
}

TEST_CASE("two blobs ten thousand cells apart cost as two") {
  const LiquidScene close(merged(std::vector{ball({0, 0, 0}, 4, 1), ball({64, 64, 64}, 4, 1)}), 1);
  const double far = 16000;
  const LiquidScene apart(merged(std::vector{ball({0, 0, 0}, 4, 1), ball({far, far, far}, 4, 1)}),
                          1);
  CHECK(apart.grid.size() == close.grid.size());
  CHECK(apart.liquid.memory() == close.liquid.memory());
}

TEST_CASE("a thin gap between liquid and a wall is not air, and a wide one is") {
  // The wall is at x = 4.6, so that centres at 4.5 are outside of it and those at 5.5 inside.
  Solids walls;
  walls.all.push_back(Solid::container({{-10, -10, -10}, {4.6, 30, 30}}));
  for (const double gap : {0.15, 0.7}) {
    const LiquidScene scene(block_of_liquid({-5, 0, 0}, {4.6 - gap, 12, 12}), 1, walls);
    const bool air = gap > kThinnestAir;
    CHECK(scene.liquid.inside(scene.grid.find({4, 6, 6})) != air);
    CHECK(scene.liquid.inside(scene.grid.find({5, 6, 6})) != air);
    CHECK(scene.liquid.inside(scene.grid.find({3, 6, 6})));
    CHECK_FALSE(scene.liquid.inside(scene.grid.find({5, 6, 13})));
  }
}
