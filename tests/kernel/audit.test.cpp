#include "kernel/audit.h"

#include <catch2/catch.hpp>
#include <limits>
#include <map>

#include "kernel/errors.h"
#include "tests/kernel/tiny.h"

using namespace suture;
using Catch::Matchers::Contains;

TEST_CASE("closed shapes pass the audit, alone and side by side") {
  CHECK(audit(tetrahedron()).closed_manifold());
  CHECK(audit(cube(0, 1)).closed_manifold());
  CHECK(audit(turned(cube(0, 1))).closed_manifold());
  CHECK(audit(joined(cube(0, 1), tetrahedron())).closed_manifold());
  CHECK_NOTHROW(require_closed_manifold(cube(0, 1), "cube"));
}

TEST_CASE("an empty surface is refused, though nothing is wrong with it") {
  CHECK(audit({}).closed_manifold());
  CHECK_THROWS_WITH(require_closed_manifold({}, "nothing.obj"),
                    Contains("nothing.obj") && Contains("empty"));
}

TEST_CASE("a missing triangle leaves three border edges") {
  Triangles s = cube(0, 1);
  s.triangles.pop_back();
  const Audit a = audit(s);
  CHECK(a.border_edges == 3);
  CHECK_FALSE(a.closed());
  CHECK(a.oriented());
  CHECK(a.edge_manifold());
  CHECK(a.non_manifold_vertices == 0);
  CHECK_THROWS_WITH(require_closed_manifold(s, "c"),
                    Contains("3 border edges") && Contains("(1, 5)"));
}

TEST_CASE("one turned triangle has three misoriented edges") {
  Triangles s = cube(0, 1);
  std::swap(s.triangles[4][0], s.triangles[4][1]);
  const Audit a = audit(s);
  CHECK(a.misoriented_edges == 3);
  CHECK(a.closed());
  CHECK_FALSE(a.closed_manifold());
  CHECK_THROWS_WITH(require_closed_manifold(s, "c"), Contains("repair orients"));
}

TEST_CASE("a fin on an edge makes it non-manifold") {
  Triangles s = tetrahedron();
  s.positions.push_back({2, 2, 2});
  s.triangles.push_back({0, 1, 4});
  const Audit a = audit(s);
  CHECK(a.non_manifold_edges == 1);
  CHECK(a.border_edges == 2);
}

TEST_CASE("two tetrahedra on one vertex make it non-manifold, wherever it is in the list") {
  const Triangles two = joined(tetrahedron(), turned(stretched(tetrahedron(), -1)));
  for (const std::uint32_t kept : {0U, 4U}) {
    Triangles s = two;
    for (Triangle& t : s.triangles)
      for (std::uint32_t& v : t)
        if (v == 0 || v == 4) v = kept;
    const Audit a = audit(s);
    CHECK(a.non_manifold_vertices == 1);
    CHECK(a.isolated_vertices == 1);
    CHECK(a.closed());
    CHECK_THAT(a.first, Contains("vertex " + std::to_string(kept)));
  }
}

TEST_CASE("duplicate triangles are found in any order of their vertices") {
  for (const Triangle& copy : {Triangle{0, 2, 1}, Triangle{2, 1, 0}, Triangle{0, 1, 2}}) {
    Triangles s = tetrahedron();
    s.triangles.push_back(copy);
    CHECK(audit(s).duplicate_triangles == 1);
    CHECK(audit(s).non_manifold_edges == 3);
  }
  const Triangles pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  const Audit a = audit(pillow);
  CHECK(a.duplicate_triangles == 1);
  CHECK(a.closed());
  CHECK_FALSE(a.closed_manifold());
}

TEST_CASE("degenerate triangles, broken indices and coordinates are counted and named") {
  Triangles s = tetrahedron();
  s.triangles.push_back({1, 1, 2});
  s.triangles.push_back({0, 1, 4});
  s.triangles.push_back({kNone, kNone, 9});
  s.positions[2][1] = std::numeric_limits<double>::quiet_NaN();
  s.positions[3][0] = -std::numeric_limits<double>::infinity();
  const Audit a = audit(s);
  CHECK(a.degenerate_triangles == 2);
  CHECK(a.indices_out_of_range == 4);
  CHECK(a.non_finite_vertices == 2);
  CHECK(a.closed());
  REQUIRE(a.faults.size() == 3);
  CHECK(a.first == a.faults[0]);
  CHECK_THAT(a.faults[0], Contains("2 vertices") && Contains("vertex 2"));
  CHECK_THAT(a.faults[1], Contains("4 vertex indices") && Contains("triangle 5"));
  CHECK_THAT(a.faults[2], Contains("2 triangles") && Contains("triangle 4"));
}

TEST_CASE("isolated vertices are counted and are no reason to fail") {
  Triangles s = tetrahedron();
  s.positions.push_back({5, 5, 5});
  CHECK(audit(s).isolated_vertices == 1);
  CHECK(audit(s).closed_manifold());
}

namespace {

// The slow twin: edges in a map, links by flooding.
struct Slow {
  std::size_t border = 0, crowded = 0, misoriented = 0, vertices = 0;
};

bool touch(const Triangle& a, const Triangle& b, std::uint32_t v) {
  for (const std::uint32_t x : a)
    for (const std::uint32_t y : b)
      if (x == y && x != v) return true;
  return false;
}

Slow slow_audit(const Triangles& s) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;
  for (const Triangle& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      auto& uses = edges[std::minmax(a, b)];
      ++(a < b ? uses.first : uses.second);
    }
  Slow slow;
  for (const auto& [edge, uses] : edges) {
    const int all = uses.first + uses.second;
    slow.border += all == 1;
    slow.crowded += all > 2;
    slow.misoriented += all == 2 && uses.first != 1;
  }
  for (std::uint32_t v = 0; v < s.positions.size(); ++v) {
    std::vector<Triangle> left, fan;
    for (const Triangle& t : s.triangles)
      if (t[0] == v || t[1] == v || t[2] == v) left.push_back(t);
    if (left.empty()) continue;
    fan.push_back(left.back());
    left.pop_back();
    for (std::size_t i = 0; i < fan.size(); ++i)
      for (std::size_t j = left.size(); j-- > 0;)
        if (touch(fan[i], left[j], v)) {
          fan.push_back(left[j]);
          left.erase(left.begin() + static_cast<std::ptrdiff_t>(j));
        }
    slow.vertices += !left.empty();
  }
  return slow;
}

}  // namespace

TEST_CASE("the audit agrees with its slow twin on 3000 random surfaces") {
  Dice dice(1);
  for (int round = 0; round < 3000; ++round) {
    Triangles s;
    const std::size_t vertices = 4 + dice.below(6), triangles = 1 + dice.below(14);
    s.positions.assign(vertices, Point::Zero());
    while (s.triangles.size() < triangles) {
      const Triangle t{static_cast<std::uint32_t>(dice.below(vertices)),
                       static_cast<std::uint32_t>(dice.below(vertices)),
                       static_cast<std::uint32_t>(dice.below(vertices))};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) s.triangles.push_back(t);
    }
    if (round % 3 == 0) {  // nearly closed ones as well
      const Triangles base = joined(cube(0, 1), tetrahedron());
      s = base;
      for (std::size_t i = dice.below(3); i > 0; --i) {
        Triangle& t = s.triangles[dice.below(s.triangles.size())];
        std::swap(t[0], t[1]);
      }
      if (dice.below(2) == 0)
        for (Triangle& t : s.triangles)
          for (std::uint32_t& v : t)
            if (v == 9) v = 0;
    }
    const Audit a = audit(s);
    const Slow slow = slow_audit(s);
    INFO("round " << round);
    REQUIRE(a.border_edges == slow.border);
    REQUIRE(a.non_manifold_edges == slow.crowded);
    REQUIRE(a.misoriented_edges == slow.misoriented);
    REQUIRE(a.non_manifold_vertices == slow.vertices);
  }
}

TEST_CASE("one vertex with 200,000 triangles costs no more than many with few") {
  Triangles s;
  const std::uint32_t n = 200000;
  s.positions.assign(n + 2, Point::Zero());
  for (std::uint32_t i = 0; i < n; ++i) {
    s.triangles.push_back({n, i, (i + 1) % n});
    s.triangles.push_back({n + 1, (i + 1) % n, i});
  }
  CHECK(audit(s).closed_manifold());
}
