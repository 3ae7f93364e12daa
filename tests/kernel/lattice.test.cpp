#include "kernel/lattice.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "kernel/errors.h"

using namespace suture;
using Catch::Matchers::Contains;

TEST_CASE("a coordinate that equals a plane belongs to the cell below it, and to no other") {
  const Lattice lattice({{{0, 1, 2, 4}, {0, 1}, {0, 1}}});
  CHECK(lattice.cell_of(0, 1.0) == 0);
  CHECK(lattice.cell_of(0, std::nextafter(1.0, 2.0)) == 1);
  CHECK(lattice.cell_of(0, 2.0) == 1);
  CHECK(lattice.cell_of(0, 3.9) == 2);
  CHECK(lattice.cell_of(0, 4.0) == 2);
  CHECK(lattice.cell_of(0, 0.0) == -1);
  CHECK(lattice.cell_of(0, 4.5) == 3);
  CHECK(lattice.cell_of(0, -7.0) == -1);
}

TEST_CASE("cells are found by their planes however unequal the spacing is") {
  std::vector<double> planes;
  for (int i = 0; i < 60; ++i) planes.push_back(std::ldexp(1.0, i - 30));
  const Lattice lattice({planes, planes, planes});
  for (int i = 0; i + 1 < 60; ++i) {
    CHECK(lattice.cell_of(1, planes[i]) == i - 1);
    CHECK(lattice.cell_of(1, (planes[i] + planes[i + 1]) / 2) == i);
  }
}

TEST_CASE("lattice ids pack, unpack and step on every axis") {
  const Index3 at = {5, kMaxPlanes - 1, 0};
  CHECK(unpack(pack(at)) == at);
  CHECK(unpack(step(pack(at), 0, -2)) == Index3{3, kMaxPlanes - 1, 0});
  CHECK(unpack(step(pack(at), 1, -1)) == Index3{5, kMaxPlanes - 2, 0});
  CHECK(unpack(step(pack(at), 2, 9)) == Index3{5, kMaxPlanes - 1, 9});
}

TEST_CASE("a lattice that cannot be held is refused in words") {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double cell : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
    CHECK_THROWS_WITH(lattice_around(box, cell), Contains("finite positive"));
  CHECK_THROWS_WITH(lattice_around(box, 1e-9), Contains("choose a larger cell"));
  CHECK_THROWS_WITH(lattice_around({{1e18, 0, 0}, {1e18 + 1024, 1, 1}}, 1.0),
                    Contains("spacing of doubles"));
  CHECK_THROWS_AS(lattice_around({{nan, 0, 0}, {1, 1, 1}}, 0.1), InvalidInput);
  CHECK_THROWS_AS(Lattice({{{0, 1}, {0, 0}, {0, 1}}}), InvalidInput);
}
