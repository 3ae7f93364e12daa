// Incidence beside what can be said of it by hand.
#include "kernel/incidence.h"

#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "kernel/shapes/shapes.h"
#include "tests/kernel/tiny.h"

using namespace suture;

TEST_CASE("each edge of a closed surface is there once, with its two triangles") {
  const Triangles ball = sphere({.frequency = 3});
  const Incidence mesh = incidence(ball);
  REQUIRE(mesh.edges.size() == ball.triangles.size() * 3 / 2);
  std::vector<int> met(mesh.edges.size(), 0);
  for (std::uint32_t t = 0; t < ball.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t e = mesh.triangle_edges[t][k];
      const std::uint32_t a = ball.triangles[t][k], b = ball.triangles[t][(k + 1) % 3];
      CHECK(mesh.edges[e] == std::array{std::min(a, b), std::max(a, b)});
      CHECK((mesh.edge_triangles[e][0] == t || mesh.edge_triangles[e][1] == t));
      ++met[e];
    }
  CHECK(met == std::vector<int>(met.size(), 2));
}

TEST_CASE("an open edge or a third triangle is refused unless edges may have any number") {
  Triangles s = tetrahedron();
  s.triangles.pop_back();
  CHECK_THROWS_AS(incidence(s), InternalFailure);
  CHECK(incidence(s, EdgeUse::any).edges.size() == 6);
  s = tetrahedron();
  s.triangles.push_back(s.triangles[0]);
  CHECK_THROWS_AS(incidence(s), InternalFailure);
  CHECK(incidence(s, EdgeUse::any).edges.size() == 6);
}
