#include "kernel/measure/self_intersections.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <catch2/catch.hpp>

#include "kernel/mesh.h"
#include "tests/kernel/tiny.h"
#include "tests/models.h"
#include "tests/skip.h"

using namespace suture;

TEST_CASE("closed convex shapes do not intersect themselves") {
  CHECK(self_intersections(cube(0, 1)).pairs.empty());
  CHECK(self_intersections(tetrahedron()).pairs.empty());
  CHECK(self_intersections({}).pairs.empty());
}

TEST_CASE("bodies that overlap, touch or coincide intersect; bodies apart do not") {
  CHECK_FALSE(self_intersections(joined(cube(0, 1), cube(0.5, 2))).pairs.empty());
  CHECK_FALSE(self_intersections(joined(cube(0, 1), cube(1, 2))).pairs.empty());  // at a corner
  CHECK(self_intersections(joined(cube(0, 1), cube(0, 1))).pairs.size() >= 12);
  CHECK(self_intersections(joined(cube(0, 1), cube(1 + 1e-15, 2))).pairs.empty());
  CHECK(self_intersections(joined(cube(0, 3), cube(1, 2))).pairs.empty());
}

TEST_CASE("triangles that share an edge intersect only if folded flat onto each other") {
  const auto pairs = [](const Point& apex) {
    return self_intersections({{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, apex}, {{0, 1, 2}, {1, 0, 3}}})
        .pairs.size();
  };
  CHECK(pairs({0.5, -1, 0}) == 0);
  CHECK(pairs({0.5, 0.5, 1e-300}) == 0);
  CHECK(pairs({0.4, 0.5, 0}) == 1);
}

TEST_CASE("triangles that share a vertex intersect if they meet elsewhere too") {
  const auto pairs = [](const Point& a, const Point& b) {
    return self_intersections({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, a, b}, {{0, 1, 2}, {0, 3, 4}}})
        .pairs;
  };
  CHECK(pairs({-1, 0, 0}, {-1, -1, 1}).empty());
  CHECK(pairs({1, 0.5, -1}, {0.5, 0.5, 1}) ==
        std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}});
}

TEST_CASE("duplicate triangles intersect; those without area are counted apart") {
  Triangles s = tetrahedron();
  s.triangles.push_back({1, 2, 0});
  s.positions.push_back({0.5, 0, 0});
  s.triangles.push_back({0, 1, 4});
  const SelfIntersections found = self_intersections(s);
  CHECK(found.pairs == std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 4}});
  CHECK(found.without_area == 1);
}

TEST_CASE("the search ends where more pairs are found than were asked for") {
  Triangles many = cube(0, 1);
  for (int copy = 1; copy < 40; ++copy) many = joined(many, cube(0, 1));
  const SelfIntersections some = self_intersections(many, {.most = 100});
  CHECK(some.pairs.size() == 100);
  CHECK(some.capped);
  const Triangles two = joined(cube(0, 1), cube(0.5, 2));
  const SelfIntersections all = self_intersections(two);
  CHECK_FALSE(all.capped);
  CHECK_FALSE(self_intersections(two, {.most = all.pairs.size()}).capped);
  CHECK(self_intersections(two, {.most = all.pairs.size() - 1}).capped);
}

TEST_CASE("the pairs are those of Polygon_mesh_processing on crumpled surfaces") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Dice dice(seed);
    Triangles s = sheet(12);
    for (Point& p : s.positions)  // on a grid, so that many cases are degenerate
      for (double& x : p) x = std::round(8 * x + 2 * dice.signed_unit()) / 8;
    std::erase_if(s.triangles, [&](const Triangle& t) {
      return CGAL::collinear(to_cgal(s.positions[t[0]]), to_cgal(s.positions[t[1]]),
                             to_cgal(s.positions[t[2]]));
    });
    const Mesh mesh = to_mesh(s);
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> theirs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(theirs));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> wanted;
    for (const auto& [f, g] : theirs) wanted.push_back(std::minmax<std::uint32_t>(f, g));
    std::sort(wanted.begin(), wanted.end());
    CHECK(wanted.size() > 50);
    CHECK(self_intersections(s).pairs == wanted);
  }
}

TEST_CASE("the horse scan has four pairs of triangles that intersect", "[slow]") {
  const auto horse = classic("horse.ply");
  if (!horse) SUTURE_SKIP("horse.ply is not at hand");
  CHECK(self_intersections(*horse).pairs.size() == 4);
}
