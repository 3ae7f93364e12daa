// Repeated triangles: one of each stays where they are part of a body, none where they part
// nothing.
#include "kernel/repair/duplicates.h"

#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "kernel/repair/repair.h"
#include "tests/kernel/tiny.h"

using namespace suture;

namespace {

// The surface with all its triangles again, on the same vertices.
Triangles with_copies(Triangles s, const std::vector<Triangle>& copies) {
  s.triangles.insert(s.triangles.end(), copies.begin(), copies.end());
  return s;
}

Triangles twice(const Triangles& s) { return with_copies(s, s.triangles); }

Triangles from_both_sides(const Triangles& s) { return with_copies(s, turned(s).triangles); }

// Two cubes side by side; the wall between them, two triangles, is given by both.
Triangles two_rooms() {
  Triangles s = joined(cube(0, 1), cube(0, 1));
  for (std::size_t v = 8; v < 16; ++v) s.positions[v][0] += 1;
  for (Triangle& t : s.triangles)
    for (std::uint32_t& v : t)
      if (v >= 8 && s.positions[v][0] == 1) v -= 7;
  return s;
}

}  // namespace

TEST_CASE("of a body whose triangles are all given twice or three times one of each stays") {
  for (const Triangles& body : {tetrahedron(), cube(0, 1), joined(cube(0, 9), turned(cube(1, 8))),
                                joined(cube(2, 3), tetrahedron())}) {
    Triangles s = twice(body);
    CHECK(drop_duplicates(s).repeated == body.triangles.size());
    CHECK(s == body);
    s = with_copies(twice(body), body.triangles);
    CHECK(drop_duplicates(s).repeated == 2 * body.triangles.size());
    CHECK(s == body);
  }
}

TEST_CASE("a body given twice beside one given once stays, and so does part of a body") {
  const Triangles both = joined(cube(2, 3), tetrahedron());
  Triangles s = with_copies(both, {both.triangles.begin() + 12, both.triangles.end()});
  CHECK(drop_duplicates(s).repeated == 4);
  CHECK(s == both);
  const Triangles box = cube(0, 1);
  for (std::size_t part = 1; part < 12; ++part)
    for (const Triangles& given : {box, turned(box)}) {
      s = with_copies(box, {given.triangles.begin(),
                            given.triangles.begin() + static_cast<std::ptrdiff_t>(part)});
      const DroppedCopies dropped = drop_duplicates(s);
      CHECK(dropped.repeated == part);
      CHECK(dropped.cancelled == 0);
      CHECK(s == box);
    }
}

TEST_CASE("a body covered from both sides encloses nothing, and goes") {
  for (const Triangles& body : {tetrahedron(), cube(0, 1), sheet(3)}) {
    Triangles s = from_both_sides(body);
    CHECK(volume(s) == 0);
    const DroppedCopies dropped = drop_duplicates(s);
    CHECK(dropped.cancelled == 2 * body.triangles.size());
    CHECK(dropped.repeated == 0);
    CHECK(s.triangles.empty());
  }
}

TEST_CASE("of copies both ways the side that is given more often stays") {
  const Triangles body = cube(0, 1), other = turned(body);
  Triangles s = with_copies(from_both_sides(body), other.triangles);
  CHECK(drop_duplicates(s).repeated == 24);
  CHECK(s == other);
  // Around such a cavity there is material, so that a repair must not turn it.
  s = joined(cube(-1, 2), with_copies(from_both_sides(body), other.triangles));
  repair(s);
  CHECK(volume(s) == 26);
}

TEST_CASE("a single copy that faces the wrong way does not take a doubled body away") {
  Triangles s = twice(cube(0, 1));
  std::swap(s.triangles[15][1], s.triangles[15][2]);
  repair(s);
  CHECK(s == cube(0, 1));
}

TEST_CASE("an open sheet that is given twice stays once") {
  Triangles s = twice(sheet(4));
  CHECK(drop_duplicates(s).repeated == sheet(4).triangles.size());
  CHECK(s == sheet(4));
}

TEST_CASE("a wall of several triangles between two rooms goes") {
  Triangles s = two_rooms();
  CHECK(audit(s).duplicate_triangles == 2);
  CHECK(drop_duplicates(s).cancelled == 4);
  CHECK(s.triangles.size() == 20);
  repair(s);
  CHECK(audit(s).closed_manifold());
  CHECK(volume(s) == 2);
  s = twice(two_rooms());
  CHECK(drop_duplicates(s).cancelled == 8);
  CHECK(s.triangles.size() == 20);
  CHECK(volume(s) == 2);
}

TEST_CASE("a doubled fin on a body goes, whichever way its copies face") {
  for (const bool opposed : {false, true}) {
    Triangles s = cube(0, 1);
    s.positions.push_back({-1, -1, 0});
    s.positions.push_back({-1, -1, 1});
    const std::vector<Triangle> fin{{0, 4, 8}, {4, 9, 8}};
    s = with_copies(with_copies(s, fin), opposed ? turned({{}, fin}).triangles : fin);
    CHECK(drop_duplicates(s).cancelled == 4);
    CHECK(s.triangles == cube(0, 1).triangles);
  }
}
