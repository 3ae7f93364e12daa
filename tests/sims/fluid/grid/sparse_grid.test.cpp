#include "sims/fluid/grid/sparse_grid.h"

#include <catch2/catch.hpp>

#include "kernel/shapes/transform.h"
#include "tests/sims/fluid/liquids.h"

using namespace suture;
using namespace suture::sims;

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
