// Triangles that are turned to agree with their neighbours.
#include "kernel/repair/orientation.h"

#include <catch2/catch.hpp>

#include "kernel/shapes/shapes.h"
#include "tests/kernel/tiny.h"

using namespace suture;

TEST_CASE("of two equally large parts the one with the first triangle stays") {
  Triangles s = tetrahedron();
  const Triangles good = s;
  for (const std::size_t i : {2U, 3U}) std::swap(s.triangles[i][1], s.triangles[i][2]);
  const TurnedTriangles turned = orient_consistently(s);
  CHECK(turned.triangles == 2);
  CHECK(turned.not_orientable == 0);
  CHECK(s == good);
}

TEST_CASE("each component is oriented by its own majority") {
  Triangles s = joined(sphere({.frequency = 2}), sphere({.centre = {5, 0, 0}, .frequency = 2}));
  const Triangles good = s;
  for (const std::size_t i : {3U, 90U, 120U}) std::swap(s.triangles[i][1], s.triangles[i][2]);
  CHECK(orient_consistently(s).triangles == 3);
  CHECK(s == good);
}

TEST_CASE("triangles with indices out of range are passed over") {
  Triangles s = tetrahedron();
  s.triangles.push_back({0, 1, 99});
  const Triangles before = s;
  CHECK(orient_consistently(s).triangles == 0);
  CHECK(s == before);
}
