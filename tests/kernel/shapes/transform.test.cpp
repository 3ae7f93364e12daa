#include "kernel/shapes/transform.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kernel/errors.h"

using namespace suture;

namespace {

const Triangles kTetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

}  // namespace

TEST_CASE("a translation and its reverse give the surface back") {
  const Triangles there = translated(kTetrahedron, {2, -3, 4});
  CHECK(there.positions[1] == Point(3, -3, 4));
  CHECK(translated(there, {-2, 3, -4}) == kTetrahedron);
}

TEST_CASE("a quarter turn about z takes x to y") {
  const Triangles turned = rotated(kTetrahedron, {0, 0, 7}, std::numbers::pi / 2);
  CHECK((turned.positions[1] - Point(0, 1, 0)).norm() < 1e-15);
  CHECK((turned.positions[2] - Point(-1, 0, 0)).norm() < 1e-15);
}

TEST_CASE("scaling takes one factor or three, and none that turns a surface inside-out") {
  CHECK(scaled(kTetrahedron, 2).positions[1] == Point(2, 0, 0));
  CHECK(scaled(kTetrahedron, Point(1, 3, 5)).positions[3] == Point(0, 0, 5));
  CHECK_THROWS_AS(scaled(kTetrahedron, 0), InvalidInput);
  CHECK_THROWS_AS(scaled(kTetrahedron, Point(1, -1, 1)), InvalidInput);
  CHECK_THROWS_AS(scaled(kTetrahedron, std::nan("")), InvalidInput);
  CHECK_THROWS_AS(rotated(kTetrahedron, Point::Zero(), 1), InvalidInput);
}

TEST_CASE("merged surfaces keep their own vertices") {
  const std::vector<Triangles> two{kTetrahedron, translated(kTetrahedron, {5, 0, 0})};
  const Triangles both = merged(two);
  CHECK(both.positions.size() == 8);
  CHECK(both.triangles.size() == 8);
  CHECK(both.triangles[4] == Triangle{4, 6, 5});
  CHECK(both.positions[5] == Point(6, 0, 0));
}
