#include "kernel/measure/nearest_triangle.h"

#include <CGAL/Exact_rational.h>

#include <catch2/catch.hpp>
#include <limits>

#include "kernel/errors.h"
#include "tests/kernel/tiny.h"
#include "tests/models.h"
#include "tests/skip.h"

using namespace suture;

namespace {

using Number = CGAL::Exact_rational;
using Exact = std::array<Number, 3>;

Exact exact(const Point& p) { return {Number(p[0]), Number(p[1]), Number(p[2])}; }
Exact minus(const Exact& a, const Exact& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Exact along(const Exact& a, const Number& t, const Exact& u) {
  return {a[0] + t * u[0], a[1] + t * u[1], a[2] + t * u[2]};
}
Number dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Number square(const Exact& a) { return dot(a, a); }

Number segment2(const Exact& p, const Exact& a, const Exact& b) {
  const Exact u = minus(b, a), w = minus(p, a);
  const Number length2 = square(u);
  if (length2 == 0) return square(w);
  const Number t = std::clamp(Number(dot(u, w) / length2), Number(0), Number(1));
  return square(minus(w, along({0, 0, 0}, t, u)));
}

// The slow twin, in rational numbers: the least over the border, and over the face by Gram's
// matrix.
double slow_distance(const Point& point, const Point& a0, const Point& b0, const Point& c0) {
  const Exact p = exact(point), a = exact(a0), b = exact(b0), c = exact(c0);
  Number best = std::min({segment2(p, a, b), segment2(p, b, c), segment2(p, c, a)});
  const Exact u = minus(b, a), v = minus(c, a), w = minus(p, a);
  const Number uu = square(u), uv = dot(u, v), vv = square(v), uw = dot(u, w), vw = dot(v, w);
  const Number det = uu * vv - uv * uv;
  if (det != 0) {
    const Number s = (vv * uw - uv * vw) / det, t = (uu * vw - uv * uw) / det;
    if (s >= 0 && t >= 0 && s + t <= 1)
      best = std::min(best, square(minus(w, along(along({0, 0, 0}, s, u), t, v))));
  }
  return std::sqrt(CGAL::to_double(best));
}

// All triangles one by one: the tree is checked against it, the distance to one triangle above.
double slow_distance(const Triangles& s, const Point& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Triangle& t : s.triangles)
    best = std::min(
        best, distance_to_triangle(p, s.positions[t[0]], s.positions[t[1]], s.positions[t[2]]));
  return best;
}

Point random_point(Dice& dice) {
  return {dice.signed_unit(), dice.signed_unit(), dice.signed_unit()};
}

}  // namespace

TEST_CASE("distances over, beside and on a triangle are exact") {
  const Point a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  CHECK(distance_to_triangle({1, 1, 3}, a, b, c) == 3);
  CHECK(distance_to_triangle({1, 1, 0}, a, b, c) == 0);
  CHECK(distance_to_triangle({-3, -4, 0}, a, b, c) == 5);
  CHECK(distance_to_triangle({2, -3, 4}, a, b, c) == 5);
  CHECK(distance_to_triangle({7, 0, -4}, a, b, c) == 5);
  CHECK(distance_to_triangle({4, 4, 0}, a, b, c) == Approx(std::sqrt(8.0)).epsilon(1e-15));
}

TEST_CASE("a triangle without area is its longest side, or its point") {
  CHECK(distance_to_triangle({1, 3, 4}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}) == 5);
  CHECK(distance_to_triangle({1, 3, 4}, {2, 0, 0}, {0, 0, 0}, {2, 0, 0}) == 5);
  CHECK(distance_to_triangle({1, 4, 6}, {1, 1, 2}, {1, 1, 2}, {1, 1, 2}) == 5);
  CHECK(distance_to_triangle({1, 1, 2}, {1, 1, 2}, {1, 1, 2}, {1, 1, 2}) == 0);
}

TEST_CASE("distances to slivers of any width are right to rounding") {
  Dice dice(7);
  for (int round = 0; round < 2000; ++round) {
    const Point a = random_point(dice), b = random_point(dice);
    const double width = std::pow(10.0, -18 * (dice.signed_unit() + 1) / 2);
    const Point c = a + (dice.signed_unit() + 1) / 2 * (b - a) + width * random_point(dice);
    const double away = std::pow(10.0, -8 * (dice.signed_unit() + 1));
    const Point p = a + (dice.signed_unit() + 1) / 2 * (b - a) + away * random_point(dice);
    INFO("round " << round << " width " << width << " away " << away);
    const double wanted = slow_distance(p, a, b, c);
    const double error = std::abs(distance_to_triangle(p, a, b, c) - wanted);
    REQUIRE(error <= 2e-15);  // measured: at most 2.3e-16, for triangles of size 1
  }
}

TEST_CASE("the tree agrees with all triangles asked one by one") {
  Dice dice(3);
  Triangles s;
  for (int i = 0; i < 300; ++i) s.positions.push_back(random_point(dice));
  for (int i = 0; i < 500; ++i)
    s.triangles.push_back({static_cast<std::uint32_t>(dice.below(300)),
                           static_cast<std::uint32_t>(dice.below(300)),
                           static_cast<std::uint32_t>(dice.below(300))});
  const NearestTriangle nearest(s);
  for (int i = 0; i < 300; ++i) {
    const Point p = 2 * random_point(dice);
    REQUIRE(nearest.distance(p) == Approx(slow_distance(s, p)).epsilon(1e-12).margin(1e-15));
    const Triangle& t = s.triangles[nearest.triangle(p)];
    REQUIRE(distance_to_triangle(p, s.positions[t[0]], s.positions[t[1]], s.positions[t[2]]) ==
            Approx(nearest.distance(p)).epsilon(1e-12).margin(1e-15));
  }
}

TEST_CASE("equally near triangles give the lowest, and equal triangles do not unbalance the tree") {
  Triangles s = tetrahedron();
  for (int i = 0; i < 20000; ++i) s.triangles.push_back(s.triangles[3]);
  const NearestTriangle nearest(s);
  CHECK(nearest.distance({-2, 0.25, 0.25}) == 2);
  CHECK(nearest.triangle({-2, 0.25, 0.25}) == 3);
}

TEST_CASE("distances scale with the surface, to the ends of the doubles") {
  for (const double scale : {0x1p-1040, 0x1p-600, 1.0, 0x1p600, 0x1p1020}) {
    INFO(scale);
    const NearestTriangle nearest(stretched(cube(0, 1), scale));
    CHECK(nearest.distance(Point(0.5, 0.5, 3) * scale) == 2 * scale);
    CHECK(nearest.distance(Point(-3, 0.5, 5) * scale) == 5 * scale);
  }
  const NearestTriangle small(stretched(cube(0, 1), 1e-30));
  CHECK(small.distance({3e200, 4e200, 0}) == Approx(5e200));
  CHECK(small.distance({1e250, 0, 0}) == 1e250);
  CHECK(NearestTriangle(stretched(cube(0, 1), 0)).distance({3, 4, 0}) == 5);
}

TEST_CASE("surfaces that cannot be asked are refused") {
  CHECK_THROWS_AS(NearestTriangle({}), InvalidInput);
  Triangles s = tetrahedron();
  s.triangles[2][1] = 4;
  CHECK_THROWS_WITH(NearestTriangle(s), Catch::Matchers::Contains("triangle 2"));
  s = tetrahedron();
  s.positions[1][0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(NearestTriangle(s), InvalidInput);
}

TEST_CASE("distances to the horse agree with all its triangles asked one by one", "[slow]") {
  const auto horse = classic("horse.ply");
  if (!horse) SUTURE_SKIP("horse.ply is not at hand");
  const NearestTriangle nearest(*horse);
  Dice dice(5);
  for (int i = 0; i < 20; ++i) {
    const Point p =
        horse->positions[dice.below(horse->positions.size())] + 0.02 * random_point(dice);
    CHECK(nearest.distance(p) == Approx(slow_distance(*horse, p)).epsilon(1e-10).margin(1e-16));
  }
}
