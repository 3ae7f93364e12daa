#include "sims/fluid/liquid/liquid.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "kernel/errors.h"
#include "kernel/shapes/transform.h"
#include "sims/support/process_pool.h"
#include "tests/sims/fluid/drops.h"
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

TEST_CASE("the inside of a big body costs no question a cell") {
  std::atomic<std::size_t> asked = 0;
  const Triangles surface = block_of_liquid({0.3, 0.3, 0.3}, {150.2, 100.4, 90.1});
  const SignedDistance exact(surface);
  const LiquidCells cells = find_liquid(
      surface,
      [&](const Point& p) {
        ++asked;
        return exact.at(p);
      },
      Point::Zero(), 1);
  const double area = 2 * (150 * 100 + 150 * 90 + 100 * 90);
  CHECK(static_cast<double>(asked.load()) < 4.2 * area);  // 4 layers, and edges
  std::size_t inside = 0;
  for (const double d : cells.distance) inside += d < 0 ? 1 : 0;
  for (const LiquidCells::Run& run : cells.deep) inside += static_cast<std::size_t>(run.count);
  CHECK(inside == 150 * 100 * 90);
}

TEST_CASE("the grid has all cells within the band of the liquid") {
  const int band = 5;
  const LiquidScene scene(ball(Point::Zero(), 2.3, 0.4), 0.2, {}, {0.05, 0, 0.1}, band);
  for (Slot s = 0; s < scene.grid.size(); ++s) {
    if (!scene.liquid.inside(s)) continue;
    const Index3 c = scene.grid.cell(s);
    for (const int x : {-band, band})
      for (const int y : {-band, band})
        for (const int z : {-band, band})
          if (scene.grid.find({c[0] + x, c[1] + y, c[2] + z}) == kNoSlot) FAIL("no band at " << s);
  }
}

TEST_CASE("where the surface crosses between two centres is where it is, not what D suggests") {
  // A floor of liquid with a wall of liquid beside it: D of the cells at its edge is that to the
  // side.
  const LiquidScene scene(block_of_liquid({0, 0, 0}, {10, 10, 6.4}), 1);
  for (const Index3& c : {Index3{0, 0, 6}, Index3{5, 5, 6}, Index3{9, 3, 6}})
    CHECK(scene.liquid.share(2, scene.grid.find(c)) == Approx(0.9).epsilon(1e-12));
  const LiquidScene turned(block_of_liquid({0, 0, -6.4}, {10, 10, 0}), 1);
  CHECK(turned.liquid.share(2, turned.grid.find({0, 0, -6})) == Approx(0.9).epsilon(1e-12));
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
      if (std::abs(scene.liquid.share(a, s) - expected) > 1e-12)
        FAIL("axis " << a << " has " << scene.liquid.share(a, s));
    }
  CHECK(found == 2 * 25 + 4 * 5 * 7);
}

TEST_CASE("a drop that holds no cell's centre is told of, one that does is not") {
  const double h = 1;
  CHECK(LiquidScene(ball({0, 0, 0}, 0.4, 0.2), h).cells.drops.size() == 1);
  CHECK(LiquidScene(ball({0.5, 0.5, 0.5}, 0.4, 0.2), h).cells.drops.size() == 0);
  const LiquidScene scene(merged(std::vector{ball({0, 0, 0}, 0.4, 0.2), ball({12, 12, 12}, 5, 1)}),
                          h);
  CHECK(scene.cells.drops.size() == 1);
  REQUIRE(scene.liquid.drops.size() == 8);
  for (const Slot s : scene.liquid.drops)
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

TEST_CASE("blobs as far apart as the grid reaches are told apart, and from where there is none") {
  constexpr int far = 1 << 24, limit = SparseGrid::kFurthest - 100;
  for (const int away : {far, limit}) {
    const double d = away;
    const LiquidScene scene(merged(std::vector{ball({0, 0, 0}, 4, 1), ball({d, -d, d}, 4, 1)}), 1);
    std::size_t here = 0, there = 0;
    for (Slot s = 0; s < scene.grid.size(); ++s) {
      const Index3 c = scene.grid.cell(s);
      if (scene.grid.find(c) != s) FAIL("slot " << s << " is not where its cell is");
      if (scene.liquid.inside(s)) ++(std::abs(c[0]) < 100 ? here : there);
      for (int a = 0; a < 3; ++a)
        for (const int side : {-1, 1}) {
          Index3 next = c;
          next[a] += side;
          if (scene.grid.neighbour(s, a, side) != scene.grid.find(next)) FAIL("other neighbour");
        }
    }
    CAPTURE(away);
    CHECK(here == there);
    CHECK(here > 200);
    // Cells that any power of two of blocks takes to one that is there.
    for (int shift = 10; shift < 29; ++shift)
      for (const int x : {-1, 0, 1})
        for (const int y : {-1, 0, 1})
          for (const int z : {-1, 0, 1}) {
            const int by = 1 << shift;
            const Index3 c{x * by, y * by, z * by};
            const bool one = c == Index3{0, 0, 0} || c == Index3{away, -away, away};
            CHECK((scene.grid.find(c) != kNoSlot) == one);
          }
  }
  // Two blocks 2^21 apart on one axis were one.
  const SparseGrid grid(Point::Zero(), 1, {{0, 0, 0}, {far, 0, 0}, {0, -far, 0}, {0, 0, 8 * far}});
  CHECK(grid.size() == 4 * SparseGrid::kCells);
  for (Slot s = 0; s < grid.size(); ++s)
    if (grid.find(grid.cell(s)) != s) FAIL("slot " << s << " is not where its cell is");
  for (const int x : {-far, 0, far}) CHECK((grid.find({x, far, 0}) == kNoSlot));
}

TEST_CASE("drops have the band round them, and a thousand a wide one at the price of its blocks") {
  Random random(11);
  std::vector<Triangles> drops;
  for (int n = 0; n < 1000; ++n) drops.push_back(ball(80 * random_vector(random), 0.3, 0.3));
  const Triangles surface = merged(drops);
  const LiquidCells cells = find_liquid(
      surface, [](const Point&) { return 0.3; }, Point::Zero(), 1);  // asked far from the surface
  REQUIRE(cells.drops.size() == 1000);
  const int band = 40;
  const double start = process_seconds();
  forget_peak();
  const double held = peak_megabytes();
  const SparseGrid grid = grid_round(cells, band);
  const double seconds = process_seconds() - start, megabytes = peak_megabytes() - held;
  CAPTURE(seconds, megabytes);
  CHECK(seconds < 2);  // measured: 0.4, and 3 MB
  CHECK(megabytes < 50);
  for (const Drop& drop : cells.drops)
    for (const Index3& c : drop.cells)
      for (const int x : {-band, 0, band})
        for (const int y : {-band, 0, band})
          for (const int z : {-band, 0, band})
            if (grid.find({c[0] + x, c[1] + y, c[2] + z}) == kNoSlot) FAIL("no band at a drop");
  // The cube of all drops with the band, rounded up to blocks on either side.
  CHECK(grid.blocks().size() <= 33 * 33 * 33);
}

TEST_CASE("no surface is no liquid, and what cannot be on the grid is refused") {
  const auto zero = [](const Point&) { return 0.0; };
  const LiquidCells none = find_liquid({}, zero, Point::Zero(), 1);
  CHECK(grid_round(none, 3).size() == 0);
  CHECK_THROWS_AS(find_liquid({}, zero, Point::Zero(), 0), InvalidInput);
  Triangles t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  t.positions[1][0] = 1e10;
  CHECK_THROWS_AS(find_liquid(t, zero, Point::Zero(), 1), InvalidInput);
  t.positions[1][0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(find_liquid(t, zero, Point::Zero(), 1), InvalidInput);
  t.positions[1][0] = 1;
  t.triangles[0][2] = 3;
  CHECK_THROWS_AS(find_liquid(t, zero, Point::Zero(), 1), InvalidInput);
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
