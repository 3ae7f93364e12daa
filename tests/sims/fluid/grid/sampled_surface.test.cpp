#include "sims/fluid/grid/sampled_surface.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <limits>

#include "kernel/errors.h"
#include "kernel/shapes/transform.h"
#include "sims/support/clock.h"
#include "tests/sims/fluid/drops.h"
#include "tests/sims/fluid/liquids.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("the inside of a big body costs no question a cell") {
  std::atomic<std::size_t> asked = 0;
  const Triangles surface = block_of_liquid({0.3, 0.3, 0.3}, {150.2, 100.4, 90.1});
  const SignedDistance exact(surface);
  const SampledSurface cells = sample_surface(surface,
                                              [&](const Point& p) {
                                                ++asked;
                                                return exact.at(p);
                                              },
                                              {Point::Zero(), 1});
  const double area = 2 * (150 * 100 + 150 * 90 + 100 * 90);
  CHECK(static_cast<double>(asked.load()) < 4.2 * area);  // 4 layers, and edges
  std::size_t inside = 0;
  for (const double d : cells.distance) inside += d < 0 ? 1 : 0;
  for (const SampledSurface::Run& run : cells.deep) inside += static_cast<std::size_t>(run.count);
  CHECK(inside == 150 * 100 * 90);
}

TEST_CASE(
    "droplets have the band round them, and a thousand a wide one at the price of its blocks") {
  Random random(11);
  std::vector<Triangles> drops;
  for (int n = 0; n < 1000; ++n) drops.push_back(ball(80 * random_vector(random), 0.3, 0.3));
  const Triangles surface = merged(drops);
  const SampledSurface cells = sample_surface(surface, [](const Point&) { return 0.3; },
                                              {Point::Zero(), 1});  // asked far from the surface
  REQUIRE(cells.droplets.size() == 1000);
  const int band = 40;
  const Lap lap;
  forget_peak();
  const double held = peak_megabytes();
  const SparseGrid grid = grid_round(cells, band);
  const double seconds = lap.seconds(), megabytes = peak_megabytes() - held;
  CAPTURE(seconds, megabytes);
  CHECK(seconds < 2);  // measured: 0.4, and 3 MB
  CHECK(megabytes < 50);
  for (const SubgridDroplet& drop : cells.droplets)
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
  const SampledSurface none = sample_surface({}, zero, {Point::Zero(), 1});
  CHECK(grid_round(none, 3).size() == 0);
  CHECK_THROWS_AS(sample_surface({}, zero, {Point::Zero(), 0}), InvalidInput);
  Triangles t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  t.positions[1][0] = 1e10;
  CHECK_THROWS_AS(sample_surface(t, zero, {Point::Zero(), 1}), InvalidInput);
  t.positions[1][0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(sample_surface(t, zero, {Point::Zero(), 1}), InvalidInput);
  t.positions[1][0] = 1;
  t.triangles[0][2] = 3;
  CHECK_THROWS_AS(sample_surface(t, zero, {Point::Zero(), 1}), InvalidInput);
}
