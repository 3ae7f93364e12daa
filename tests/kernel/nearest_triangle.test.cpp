#include "kernel/nearest_triangle.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <limits>

#include "kernel/errors.h"
#include "tests/kernel/tiny.h"
#include "tests/models.h"

using namespace suture;

namespace {

using Wide = Eigen::Matrix<long double, 3, 1>;

long double segment2(const Wide& p, const Wide& a, const Wide& b) {
  const Wide ab = b - a;
  const long double l = ab.squaredNorm();
  const long double t = l > 0 ? std::clamp(ab.dot(p - a) / l, 0.0L, 1.0L) : 0.0L;
  return (p - a - t * ab).squaredNorm();
}

// The slow twin: the least over the border, and over the face by its own two coordinates (Gram's
// matrix instead of normals), in extended precision.
double slow_distance(const Point& point, const Point& a0, const Point& b0, const Point& c0) {
  const Wide p = point.cast<long double>(), a = a0.cast<long double>(),
             u = b0.cast<long double>() - a, v = c0.cast<long double>() - a, w = p - a;
  long double best = std::min({segment2(p, a, b0.cast<long double>()),
                               segment2(p, b0.cast<long double>(), c0.cast<long double>()),
                               segment2(p, c0.cast<long double>(), a)});
  const long double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
  const long double det = uu * vv - uv * uv;
  if (det > 1e-12L * uu * vv) {
    const long double s = (vv * uw - uv * vw) / det, t = (uu * vw - uv * uw) / det;
    if (s >= 0 && t >= 0 && s + t <= 1) best = std::min(best, (w - s * u - t * v).squaredNorm());
  }
  return static_cast<double>(std::sqrt(best));
}

double slow_distance(const Triangles& s, const Point& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Triangle& t : s.triangles)
    best =
        std::min(best, slow_distance(p, s.positions[t[0]], s.positions[t[1]], s.positions[t[2]]));
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
  for (int round = 0; round < 20000; ++round) {
    const Point a = random_point(dice), b = random_point(dice);
    const double width = std::pow(10.0, -18 * (dice.signed_unit() + 1) / 2);
    const Point c = a + (dice.signed_unit() + 1) / 2 * (b - a) + width * random_point(dice);
    const double away = std::pow(10.0, -8 * (dice.signed_unit() + 1));
    const Point p = a + (dice.signed_unit() + 1) / 2 * (b - a) + away * random_point(dice);
    INFO("round " << round << " width " << width << " away " << away);
    // Measured: worst 3.3e-16 of the triangle's size of 1; the twin drops widths below 1e-6.
    const double slow = slow_distance(p, a, b, c);
    REQUIRE(std::abs(distance_to_triangle(p, a, b, c) - slow) <=
            1e-14 + (width < 1e-5 ? 2 * width : 0));
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
  for (int i = 0; i < 1000; ++i) {
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
    const NearestTriangle nearest(scaled(cube(0, 1), scale));
    CHECK(nearest.distance(Point(0.5, 0.5, 3) * scale) == 2 * scale);
    CHECK(nearest.distance(Point(-3, 0.5, 5) * scale) == 5 * scale);
  }
  const NearestTriangle small(scaled(cube(0, 1), 1e-30));
  CHECK(small.distance({3e200, 4e200, 0}) == Approx(5e200));
  CHECK(small.distance({1e250, 0, 0}) == 1e250);
  CHECK(NearestTriangle(scaled(cube(0, 1), 0)).distance({3, 4, 0}) == 5);
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

TEST_CASE("distances to the horse agree with all its triangles asked one by one") {
  const auto horse = classic("horse.ply");
  if (!horse) {
    WARN("horse.ply is not at hand: skipped");
    return;
  }
  const NearestTriangle nearest(*horse);
  Dice dice(5);
  for (int i = 0; i < 20; ++i) {
    const Point p =
        horse->positions[dice.below(horse->positions.size())] + 0.02 * random_point(dice);
    CHECK(nearest.distance(p) == Approx(slow_distance(*horse, p)).epsilon(1e-10).margin(1e-16));
  }
}
