// Positions against exact rationals: no neighbouring double may be nearer.
#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "tests/brute/construct_questions.h"

using namespace suture;
using namespace suture::brute;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The first of `cases` mistakes that `make_mistake` makes, or nothing.
template <class Make>
std::string first_mistake(std::uint64_t seed, int cases, const Make& make_mistake) {
  Draws random(seed);
  for (int i = 0; i < cases; ++i)
    if (std::string text = make_mistake(random); !text.empty()) return text;
  return "";
}

template <class Question>
std::string mistake(const Question& question) {
  return crosses(question) ? mistake(question, ask(question)) : "";
}

}  // namespace

TEST_CASE("a point on an edge is the double nearest to the exact one, whatever the edge") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(first_mistake(21, 8'000, [&](Draws& random) {
            return mistake(edge_question(family, random));
          }) == "");
  }
}

TEST_CASE("a point on a triangle is the double nearest to the exact one, whatever the triangle") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(first_mistake(22, 5'000, [&](Draws& random) {
            return mistake(triangle_question(family, random));
          }) == "");
  }
}

TEST_CASE("a point halfway between two doubles, or almost, is rounded correctly") {
  CHECK(first_mistake(23, 20'000,
                      [](Draws& random) { return mistake(edge_near_halfway(random)); }) == "");
  CHECK(first_mistake(24, 20'000,
                      [](Draws& random) { return mistake(triangle_near_halfway(random)); }) == "");
}

TEST_CASE("a crossing at an end of an edge is that end, to the bit") {
  CHECK(first_mistake(25, 10'000, [](Draws& random) {
          const Point p = random.point(), q = random.point();
          return on_edge(p, q, 0, p[0], 2) == p[2] && on_edge(p, q, 0, q[0], 2) == q[2]
                     ? std::string()
                     : show(p) + show(q);
        }) == "");
}

TEST_CASE("the ends of an edge and the corners of a triangle may come in any order") {
  Draws random(26);
  for (int i = 0; i < 1'000; ++i) {
    const Points4 p = near_degenerate(Family::random, random);
    REQUIRE(on_edge(p[0], p[1], 1, p[2][1], 0) == on_edge(p[1], p[0], 1, p[2][1], 0));
    const double height = on_triangle(p[0], p[1], p[2], 1, p[3]);
    REQUIRE(height == on_triangle(p[1], p[2], p[0], 1, p[3]));
    REQUIRE(height == on_triangle(p[2], p[1], p[0], 1, p[3]));
  }
}

TEST_CASE("results that overflow are infinite, and subnormal ones round once") {
  CHECK(on_edge({0, 0, 0}, {1, 0x1p1023, 0}, 0, 4, 1) == kInfinity);
  CHECK(on_edge({0, 0, 0}, {1, -0x1p1023, 0}, 0, 4, 1) == -kInfinity);
  CHECK(on_edge({0, 0, 0}, {3, 0x1p-1074, 0}, 0, 1, 1) == 0);
  CHECK(on_edge({0, 0, 0}, {3, 0x1p-1074, 0}, 0, 2, 1) == 0x1p-1074);
  CHECK(on_edge({0, 0, 0}, {2, 0x1p-1074, 0}, 0, 1, 1) == 0);                  // tie to even
  CHECK(on_edge({0, 0x1p-1074, 0}, {2, 0x1p-1073, 0}, 0, 1, 1) == 0x1p-1073);  // and upwards
}

TEST_CASE("what nothing crosses is refused") {
  CHECK_THROWS_AS(on_edge({1, 0, 0}, {1, 1, 0}, 0, 1, 1), InternalFailure);
  CHECK_THROWS_AS(on_triangle({0, 0, 0}, {1, 0, 1}, {2, 0, 3}, 2, {1, 1, 0}), InternalFailure);
}

TEST_CASE("a clamped coordinate is the nearest one that its cell holds") {
  const Lattice lattice({{{-0.1, 0, 0.1, 0x1p60}, {0, 1}, {0, 1}}});
  CHECK(clamp_to_cell(0.05, 0, 0.1) == 0.05);
  CHECK(clamp_to_cell(0.1, 0, 0.1) == 0.1);
  CHECK(clamp_to_cell(0.2, 0, 0.1) == 0.1);
  CHECK(clamp_to_cell(0, 0, 0.1) == 0x1p-1074);
  CHECK(clamp_to_cell(-5, 0, 0.1) == 0x1p-1074);
  CHECK(clamp_to_cell(-5, 1, nudged(1, 1)) == nudged(1, 1));
  for (int cell = 0; cell < lattice.cells(0); ++cell)
    for (double x : {-1e300, -0.1, -0.05, -0.0, 0.0, 0.05, 0.1, 7.0, 0x1p60, 1e300}) {
      INFO(cell << ' ' << x);
      const double low = lattice.plane(0, cell), high = lattice.plane(0, cell + 1);
      CHECK(lattice.cell_of(0, clamp_to_cell(x, low, high)) == cell);
    }
}
