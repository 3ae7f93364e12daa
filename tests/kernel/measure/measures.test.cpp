#include "kernel/measure/measures.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/kernel/tiny.h"

using namespace suture;

TEST_CASE("volume and area of a cube and a tetrahedron are exact") {
  CHECK(volume(cube(-1, 1)) == 8);
  CHECK(area(cube(-1, 1)) == 24);
  CHECK(volume(tetrahedron()) == 1.0 / 6);
  CHECK(volume(turned(cube(0, 1))) == -1);
  CHECK(volume({}) == 0);
}

TEST_CASE("volume does not suffer from a far origin") {
  Triangles s = cube(0, 1);
  for (Point& p : s.positions) p += Point(1e9, -3e9, 7e9);
  CHECK(volume(s) == 1);
}

TEST_CASE("measures hold at lengths whose squares and cubes leave the doubles") {
  CHECK(volume(stretched(cube(0, 1), 1e100)) == Approx(1e300).epsilon(1e-15));
  CHECK(area(stretched(cube(0, 1), 1e-160)) == Approx(6e-320).epsilon(1e-3));
  CHECK(edge_lengths(stretched(cube(0, 1), 1e200)).longest == Approx(std::sqrt(2) * 1e200));
  CHECK(angles(stretched(cube(0, 1), 1e-200)).smallest == Approx(45));
  CHECK(angles(stretched(cube(0, 1), 1e200)).largest == Approx(90));
}

TEST_CASE("Euler characteristic counts used vertices only, and open surfaces too") {
  CHECK(euler_characteristic(cube(0, 1)) == 2);
  CHECK(euler_characteristic(joined(cube(0, 1), tetrahedron())) == 4);
  CHECK(euler_characteristic(sheet(5)) == 1);
  Triangles s = cube(0, 1);
  s.positions.push_back({9, 9, 9});
  CHECK(euler_characteristic(s) == 2);
}

TEST_CASE("components are numbered as they first appear") {
  const Components c = components(joined(tetrahedron(), joined(cube(2, 3), tetrahedron())));
  CHECK(c.count == 3);
  REQUIRE(c.of_triangle.size() == 20);
  CHECK(c.of_triangle[0] == 0);
  CHECK(c.of_triangle[4] == 1);
  CHECK(c.of_triangle[15] == 1);
  CHECK(c.of_triangle[16] == 2);
  CHECK(components({}).count == 0);
}

TEST_CASE("every edge counts once in the mean length, on borders too") {
  const EdgeLengths e = edge_lengths({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  CHECK(e.shortest == 3);
  CHECK(e.mean == 4);
  CHECK(e.longest == 5);
  CHECK(edge_lengths(cube(0, 1)).mean == Approx((12 + 6 * std::sqrt(2)) / 18));
}

TEST_CASE("angles of a triangle without area are 0 and 180") {
  const Angles flat = angles({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}});
  CHECK(flat.smallest == 0);
  CHECK(flat.largest == 180);
  const Angles point = angles({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}});
  CHECK(point.smallest == 0);
  const Angles sliver = angles({{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}}});
  CHECK(sliver.smallest == Approx(2e-9 * 57.295779513082320877));
  CHECK(sliver.largest == Approx(180));
}
