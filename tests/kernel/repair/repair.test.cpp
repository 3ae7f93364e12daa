#include "kernel/repair/repair.h"

#include <catch2/catch.hpp>
#include <limits>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/repair/inside_out.h"
#include "kernel/repair/orientation.h"
#include "tests/kernel/tiny.h"
#include "tests/models.h"
#include "tests/skip.h"

using namespace suture;
using Catch::Matchers::Contains;

namespace {

// Repairs twice: the second time nothing may be left to do.
RepairReport repaired(Triangles& s) {
  const RepairReport report = repair(s);
  Triangles again = s;
  CHECK_FALSE(repair(again).changed());
  CHECK(same_bits(again, s));
  return report;
}

using Found = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a good surface is left as it is, to the last bit") {
  for (const Triangles& whole : {cube(-0.0, 1), joined(cube(0, 3), turned(cube(1, 2)))}) {
    Triangles s = whole;
    CHECK_FALSE(repaired(s).changed());
    CHECK(same_bits(s, whole));
    CHECK_NOTHROW(require_usable(s, "s"));
  }
}

TEST_CASE("an inside-out body is refused, and repair turns it") {
  Triangles s = turned(cube(0, 1));
  CHECK_THROWS_WITH(require_usable(s, "box.obj"), Contains("box.obj") &&
                                                      Contains("1 component is inside-out") &&
                                                      Contains("a repair"));
  const RepairReport report = repaired(s);
  CHECK(report.inside_out_components == 1);
  CHECK(report.turned_triangles == 0);
  CHECK(report.in_words() == std::vector<std::string>{"1 inside-out component was turned over"});
  CHECK(volume(s) == 1);
}

TEST_CASE("a body with a cavity that is inside-out as a whole is turned as a whole") {
  const Triangles good = joined(cube(0, 9), turned(cube(1, 8)));
  Triangles s = turned(good);
  CHECK(inside_out_components(s) == Found{0, 12});
  CHECK(repaired(s).inside_out_components == 2);
  CHECK(volume(s) == volume(good));
  s = joined(turned(cube(0, 9)), turned(cube(1, 8)));  // here only the outer one is wrong
  CHECK(inside_out_components(s) == Found{0});
}

TEST_CASE("triangles are turned to agree, the fewer ones") {
  Triangles s = cube(0, 1);
  for (const std::size_t i : {0U, 3U, 7U}) std::swap(s.triangles[i][0], s.triangles[i][1]);
  const RepairReport report = repaired(s);
  CHECK(report.turned_triangles == 3);
  CHECK(report.inside_out_components == 0);
  CHECK(volume(s) == 1);
  CHECK(audit(s).closed_manifold());
}

TEST_CASE("a surface that cannot be oriented is left to be refused") {
  // A Möbius strip of six triangles.
  Triangles s;
  for (int i = 0; i < 6; ++i) s.positions.push_back({double(i), double(i * i), double(i % 2)});
  for (std::uint32_t i = 0; i < 6; ++i) s.triangles.push_back({i, (i + 1) % 6, (i + 2) % 6});
  s.triangles.pop_back();
  s.triangles.pop_back();
  s.triangles.push_back({4, 5, 1});
  s.triangles.push_back({5, 1, 0});
  const std::vector<Triangle> before = s.triangles;
  CHECK(orient_consistently(s).not_orientable == 1);
  CHECK(s.triangles == before);
  CHECK_THROWS_AS(require_usable(s, "strip"), InvalidInput);
}

TEST_CASE("a soup of triangles is welded to a closed surface") {
  Triangles s = soup(cube(0, 1));
  const RepairReport report = repaired(s);
  CHECK(report.welded_vertices == 36 - 8);
  CHECK(report.isolated_vertices == 0);
  CHECK(s.positions.size() == 8);
  CHECK(audit(s).closed_manifold());
  CHECK(volume(s) == 1);
}

TEST_CASE("closed surfaces that touch are not welded together") {
  const Triangles two = joined(cube(0, 1), cube(1, 2)), twice = joined(cube(0, 1), cube(0, 1));
  for (const Triangles& whole : {two, twice}) {
    Triangles s = whole;
    CHECK_FALSE(repaired(s).changed());
  }
}

TEST_CASE("borders that coincide three times are left, since which two belong together is open") {
  const Triangles fins{{{0, 0, 0},
                        {0, 0, 1},
                        {1, 0, 0},
                        {0, 0, 0},
                        {0, 0, 1},
                        {0, 1, 0},
                        {0, 0, 0},
                        {0, 0, 1},
                        {-1, -1, 0}},
                       {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}};
  Triangles s = fins;
  CHECK(repaired(s).welded_vertices == 0);
}

TEST_CASE("degenerate and repeated triangles and isolated vertices are dropped") {
  Triangles s = cube(0, 1);
  s.triangles.insert(s.triangles.begin() + 2, {0, 0, 1});
  s.triangles.push_back(s.triangles[5]);
  s.triangles.push_back({s.triangles[0][1], s.triangles[0][0], s.triangles[0][2]});
  s.positions.insert(s.positions.end(), 3, Point(7, 7, 7));
  const RepairReport report = repaired(s);
  CHECK(report.degenerate_triangles == 1);
  CHECK(report.duplicate_triangles == 2);
  CHECK(report.isolated_vertices == 3);
  CHECK(report.in_words().size() == 3);
  CHECK(same_bits(s, cube(0, 1)));
}

TEST_CASE("a wall between two bodies goes, a pillow goes whole") {
  // Two tetrahedra on one face, which both have.
  Triangles s = tetrahedron();
  s.positions.push_back({-1, -1, -1});
  s.triangles.insert(s.triangles.end(), {{0, 1, 2}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}});
  CHECK(audit(s).non_manifold_edges == 3);
  CHECK(repaired(s).cancelled_triangles == 2);
  CHECK(audit(s).closed_manifold());
  s = joined(tetrahedron(), {{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  CHECK(repaired(s).cancelled_triangles == 2);
  CHECK(same_bits(s, tetrahedron()));
}

TEST_CASE("a tetrahedron that is listed twice is repaired to one, and what was done is said") {
  Triangles s = tetrahedron();
  s.triangles.insert(s.triangles.end(), {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  CHECK(repaired(s).in_words() == std::vector<std::string>{"4 repeated triangles were dropped"});
  CHECK(same_bits(s, tetrahedron()));
  for (const Triangle& t : turned(s).triangles) s.triangles.push_back(t);
  CHECK(repaired(s).in_words().front() ==
        "8 triangles were dropped with all their copies, as they enclosed nothing");
  CHECK_THROWS_WITH(require_usable(s, "s"), Contains("the mesh is empty"));
}

TEST_CASE("a vertex that joins fans is split") {
  Triangles s = joined(tetrahedron(), turned(stretched(tetrahedron(), -1)));
  for (Triangle& t : s.triangles)
    for (std::uint32_t& v : t)
      if (v == 4) v = 0;
  CHECK_THROWS_WITH(require_usable(s, "s"), Contains("a repair splits"));
  const RepairReport report = repaired(s);
  CHECK(report.split_vertices == 1);
  CHECK(report.isolated_vertices == 1);
  CHECK(audit(s).closed_manifold());
  CHECK(components(s).count == 2);
}

TEST_CASE("what cannot be repaired is left alone") {
  Triangles s = cube(0, 1);
  s.positions[3][0] = std::numeric_limits<double>::infinity();
  CHECK_FALSE(repair(s).changed());
  s = cube(0, 1);
  s.triangles[4][2] = 8;
  CHECK_FALSE(repair(s).changed());
  CHECK_THROWS_AS(require_usable(s, "s"), InvalidInput);
  Triangles open = sheet(3);
  CHECK_FALSE(repaired(open).changed());
  CHECK_THROWS_AS(require_usable(open, "s"), InvalidInput);
  Triangles none;
  CHECK_FALSE(repair(none).changed());
}

TEST_CASE("3000 random surfaces are repaired without harm, and once is enough") {
  Dice dice(11);
  std::size_t mended = 0;
  for (int round = 0; round < 3000; ++round) {
    Triangles s;
    const std::size_t vertices = 4 + dice.below(6), triangles = 1 + dice.below(14);
    for (std::size_t v = 0; v < vertices; ++v)
      s.positions.push_back({double(dice.below(3)), double(dice.below(3)), double(dice.below(3))});
    for (std::size_t i = 0; i < triangles; ++i)
      s.triangles.push_back({static_cast<std::uint32_t>(dice.below(vertices)),
                             static_cast<std::uint32_t>(dice.below(vertices)),
                             static_cast<std::uint32_t>(dice.below(vertices))});
    const bool was = audit(s).closed_manifold();
    repaired(s);
    const Audit a = audit(s);
    REQUIRE(a.degenerate_triangles == 0);
    REQUIRE(a.duplicate_triangles == 0);
    REQUIRE(a.non_manifold_vertices == 0);
    REQUIRE(a.isolated_vertices == 0);
    if (a.closed_manifold()) REQUIRE(inside_out_components(s).empty());
    mended += !was && a.closed_manifold() && !s.triangles.empty() ? 1 : 0;
  }
  CHECK(mended > 0);
}

TEST_CASE("the classic horse, cow and bunny have the faults they are known for", "[slow]") {
  const auto horse = classic("horse.ply"), cow = classic("cow.obj"),
             bunny = classic("bunny-with-holes.obj");
  if (!horse || !cow || !bunny)
    SUTURE_SKIP("horse.ply, cow.obj or bunny-with-holes.obj is not at hand");
  CHECK_THROWS_WITH(require_usable(*horse, "horse"), Contains("inside-out"));
  CHECK(volume(*horse) == Approx(-2.63418e-4));
  Triangles s = *horse;
  CHECK(repaired(s).inside_out_components == 1);
  CHECK_NOTHROW(require_usable(s, "horse"));
  CHECK_THROWS_WITH(require_usable(*cow, "cow"), Contains("1 vertex joins"));
  s = *cow;
  CHECK(repaired(s).split_vertices == 1);
  CHECK_NOTHROW(require_usable(s, "cow"));
  const Audit a = audit(*bunny);
  CHECK(a.border_edges == 223);
  CHECK(a.isolated_vertices == 1113);
  CHECK_THROWS_WITH(require_usable(*bunny, "bunny"), Contains("223 border edges"));
}
