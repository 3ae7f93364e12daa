#include "sims/fluid/grid/cell_boxes.h"

#include <catch2/catch.hpp>

#include "kernel/random.h"
#include "tests/sims/fluid/cells.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("boxes hold each active cell once and nothing that does not exist") {
  std::vector<Index3> round;
  for (const Index3& c : {Index3{0, 0, 0}, Index3{30, 2, -40}, Index3{17, 19, 3}})
    for (int x = -9; x <= 9; ++x)
      for (int y = -9; y <= 9; ++y)
        for (int z = -9; z <= 9; ++z) round.push_back({c[0] + x, c[1] + y, c[2] + z});
  const SharedGrid grid = shared_grid(Point::Zero(), 1, round);
  Random random(6);
  std::vector<std::uint8_t> active(grid->size());
  for (auto& a : active) a = random.below(40) == 0 ? 1 : 0;
  std::vector<int> times(grid->size(), 0);
  for (const CellBox& box : active_boxes(*grid, active))
    for (const Index3& c : cells_in(box.low, box.high)) {
      REQUIRE(grid->find(c) != kNoSlot);
      ++times[grid->find(c)];
    }
  for (Slot s = 0; s < grid->size(); ++s) {
    CHECK(times[s] <= 1);
    if (active[s] != 0) CHECK(times[s] == 1);
  }
}
