#include "sims/baselines/grid/level_set_grid.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/measure/signed_distance.h"
#include "kernel/random.h"
#include "kernel/shapes/shapes.h"
#include "tests/sims/balls.h"

using namespace suture;
using namespace suture::sims;

namespace {

BandOptions lattice(double cell) { return {cell, {0.01, 0.02, -0.03}, 3}; }

}  // namespace

TEST_CASE("a new level set holds the exact distances in its band, and its width beyond") {
  const Triangles slotted = zalesak(
      {.centre = {0, 0, 0}, .radius = 1, .slot_width = 0.3, .slot_top = 0.6, .edge_length = 0.1});
  const BandOptions o = lattice(0.07);
  const auto grid = make_level_set(slotted, o);
  const SignedDistance distance(slotted);
  auto values = grid->getConstAccessor();
  std::size_t in_band = 0;
  for (int i = -22; i <= 22; ++i)
    for (int j = -22; j <= 22; ++j)
      for (int k = -22; k <= 22; ++k) {
        const double exact = distance.at(o.place({i, j, k})) / o.cell_size;
        const double wanted = std::clamp(exact, -o.half_width, o.half_width);
        in_band += std::abs(exact) < o.half_width;
        REQUIRE(values.getValue({i, j, k}) == static_cast<float>(wanted));
        REQUIRE(values.isValueOn({i, j, k}) == (std::abs(exact) < o.half_width));
      }
  CHECK(grid->activeVoxelCount() == in_band);
}

TEST_CASE("bodies that overlap and lattices in line with a box, give closed manifolds") {
  const Triangles two = beside(subdivided_ball(3, 1), subdivided_ball(3, 1), {1.2, 0.3, 0});
  const BandOptions o = lattice(0.1);
  const Triangles together = contour(*make_level_set(two, o), o);
  CHECK(audit(together).closed_manifold());
  CHECK(components(together).count == 1);

  const BandOptions aligned{0.125, Point::Zero(), 3};
  const Triangles brick = box({.size = {1, 1.5, 2}, .edge_length = 0.3});
  const Triangles again = contour(*make_level_set(brick, aligned), aligned);
  CHECK(audit(again).closed_manifold());
  // Along half of the box's edges, 18 long, the diagonals of the cubes cut off half a cell.
  CHECK(volume(again) == Approx(3 - 18.0 / 2 * 0.5 * 0.125 * 0.125).margin(0.005));
}

TEST_CASE("contours of a ball's level set converge to it with the square of the cell") {
  const Triangles ball = sphere({.radius = 1, .edge_length = 0.03});
  std::vector<double> errors;
  for (const double cell : {0.24, 0.12, 0.06}) {
    const Triangles contoured = contour(*make_level_set(ball, lattice(cell)), lattice(cell));
    CHECK(audit(contoured).closed_manifold());
    errors.push_back(std::abs(volume(contoured) / volume(ball) - 1));
  }
  CHECK(std::log2(errors[0] / errors[1]) == Approx(2).margin(0.2));
  CHECK(std::log2(errors[1] / errors[2]) == Approx(2).margin(0.2));
}

TEST_CASE("contours are closed and manifold whatever the values at the nodes are") {
  Random random(4);
  const BandOptions o{1, Point::Zero(), 3};
  for (int round = 0; round < 20; ++round) {
    const auto grid = openvdb::FloatGrid::create(3);
    auto values = grid->getAccessor();
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j)
        for (int k = 0; k < 10; ++k) {
          const double value = random.uniform(-1, 1);
          values.setValue({i, j, k}, round % 2 == 0 ? float(value) : std::round(float(value)));
        }
    REQUIRE(audit(contour(*grid, o)).closed_manifold());
  }
}

TEST_CASE("a surface without triangles is an empty level set, and has an empty contour") {
  const BandOptions o = lattice(0.1);
  const auto grid = make_level_set({}, o);
  CHECK(grid->activeVoxelCount() == 0);
  CHECK(contour(*grid, o).triangles.empty());
}

TEST_CASE("the same body at another scale gives the same grid") {
  const Triangles ball = subdivided_ball(3, 1);
  const auto grid = make_level_set(ball, {0.1, {0.01, 0, 0}, 3});
  Triangles small = ball;
  for (Point& p : small.positions) p *= 0x1p-100;
  const auto again = make_level_set(small, {0.1 * 0x1p-100, {0.01 * 0x1p-100, 0, 0}, 3});
  REQUIRE(again->activeVoxelCount() == grid->activeVoxelCount());
  auto values = again->getConstAccessor();
  for (auto at = grid->cbeginValueOn(); at; ++at) REQUIRE(*at == values.getValue(at.getCoord()));
}

TEST_CASE("grids refuse sizes that make no band") {
  const Triangles ball = subdivided_ball(1, 1);
  CHECK_THROWS_AS(make_level_set(ball, {0, Point::Zero(), 3}), InvalidInput);
  CHECK_THROWS_AS(make_level_set(ball, {0.1, Point::Zero(), 0.5}), InvalidInput);
  CHECK_THROWS_AS(make_level_set(ball, {0.1, {1e9, 0, 0}, 3}), InvalidInput);
  CHECK_THROWS_AS(make_level_set(ball, {1e-7, Point::Zero(), 3}), InvalidInput);
}
