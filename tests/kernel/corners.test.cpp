// Corners beside a search through all triangles.
#include "kernel/corners.h"

#include <catch2/catch.hpp>
#include <map>

#include "kernel/shapes/shapes.h"
#include "tests/kernel/tiny.h"

using namespace suture;

TEST_CASE("each corner of a usable triangle is at its vertex, in the order of the triangles") {
  Triangles s = sphere({.frequency = 2});
  s.triangles.push_back({0, 0, 1});
  s.triangles.push_back({0, 1, 4000});
  const Corners corners(s);
  std::size_t found = 0;
  for (std::uint32_t v = 0; v < s.positions.size(); ++v) {
    std::uint32_t last = 0;
    for (const Corner& c : corners.of(v)) {
      const Triangle& t = s.triangles[c.triangle];
      const bool turned = t == Triangle{v, c.next, c.prev} || t == Triangle{c.prev, v, c.next} ||
                          t == Triangle{c.next, c.prev, v};
      CHECK(turned);
      CHECK(c.triangle >= last);
      last = c.triangle;
      ++found;
    }
  }
  CHECK(found == 3 * (s.triangles.size() - 2));
}

TEST_CASE("each use of an edge is met once, with its direction, from either end") {
  const Triangles s = cube(0, 1);
  const Corners corners(s);
  for (const Triangle& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      std::map<bool, int> uses;
      corners.for_each_use(t[k], t[(k + 1) % 3], [&](std::uint32_t, bool along) { ++uses[along]; });
      CHECK(uses == std::map<bool, int>{{false, 1}, {true, 1}});
    }
}
