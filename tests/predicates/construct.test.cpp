// Positions against exact rationals: no neighbouring double may be nearer.
#include "predicates/construct.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "kernel/errors.h"
#include "kernel/lattice.h"
#include "tests/brute/exact_positions.h"
#include "tests/brute/near_degenerate.h"

using namespace suture;
using namespace suture::brute;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string show(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a ", x);
  return text;
}

std::string show(const Point& p) { return show(p[0]) + show(p[1]) + show(p[2]); }

/// The edge, if its point is not correctly rounded; else nothing.
std::string mistake(const EdgeQuestion& e) {
  const double result = on_edge(e.p, e.q, e.axis, e.plane, e.want);
  if (is_nearest(result, exact_on_edge(e))) return "";
  return show(result) + "on edge " + show(e.p) + show(e.q) + "plane " + show(e.plane) +
         std::to_string(e.axis) + std::to_string(e.want);
}

std::string mistake(const Points4& t, int axis) {
  const mpq_class area = twice_area(t[0], t[1], t[2], next_axis(axis), prev_axis(axis));
  if (area == 0) return "";
  const double result = on_triangle(t[0], t[1], t[2], axis, t[3]);
  if (is_nearest(result, exact_on_triangle(t, axis, area))) return "";
  return show(result) + "on triangle " + show(t[0]) + show(t[1]) + show(t[2]) + "through " +
         show(t[3]) + std::to_string(axis);
}

/// The first of `cases` mistakes that `make_mistake` makes, or nothing.
template <class Make>
std::string first_mistake(std::uint64_t seed, int cases, const Make& make_mistake) {
  Draws random(seed);
  for (int i = 0; i < cases; ++i)
    if (std::string text = make_mistake(random); !text.empty()) return text;
  return "";
}

EdgeQuestion edge_in(const Points4& points, Draws& random) {
  const int axis = random.below(3), want = (axis + random.between(1, 2)) % 3;
  return {points[0], points[1], axis, want, points[2][axis]};
}

/// An edge whose point lies halfway between two doubles, or off it by as little as 2^-1000 of them.
EdgeQuestion near_halfway(Draws& random) {
  EdgeQuestion e{random.point(), random.point(), 0, 1, 0};
  e.q[1] = nudged(e.p[1], 2 * random.below(3) + 1);
  e.p[0] = -1;
  e.q[0] = 1;
  if (random.below(4)) e.plane = std::ldexp(random.below(2) ? 1 : -1, -random.between(40, 1000));
  return e;
}

/// The same for a triangle: its heights differ by one ulp, and it is met near its middle.
Points4 triangle_near_halfway(Draws& random) {
  const double low = random.real(), high = nudged(low, 1);
  const double off = random.below(4) ? std::ldexp(1, -random.between(40, 1000)) : 0;
  const double y = random.real();
  return {Point(-1, -1, low), Point(1, -1, high), Point(0, 1, random.below(2) ? low : high),
          Point(off, random.below(2) ? -1 : y, 0)};
}

}  // namespace

TEST_CASE("a point on an edge is the double nearest to the exact one, whatever the edge") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(first_mistake(21, 8'000, [&](Draws& random) {
            const EdgeQuestion e = edge_in(near_degenerate(family, random), random);
            return e.p[e.axis] == e.q[e.axis] ? std::string() : mistake(e);
          }) == "");
  }
}

TEST_CASE("a point on a triangle is the double nearest to the exact one, whatever the triangle") {
  for (Family family : kFamilies) {
    INFO(family);
    CHECK(first_mistake(22, 5'000, [&](Draws& random) {
            const Points4 t = near_degenerate(family, random);
            return mistake(t, random.below(3));
          }) == "");
  }
}

TEST_CASE("a point halfway between two doubles, or almost, is rounded correctly") {
  CHECK(first_mistake(23, 20'000, [](Draws& random) { return mistake(near_halfway(random)); }) ==
        "");
  CHECK(first_mistake(24, 20'000, [](Draws& random) {
          return mistake(triangle_near_halfway(random), 2);
        }) == "");
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
