#include "kernel/measure/signed_distance.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "kernel/shapes/shapes.h"
#include "tests/kernel/tiny.h"

using namespace suture;

namespace {

Point random_point(Dice& dice) {
  const double x = dice.signed_unit(), y = dice.signed_unit(), z = dice.signed_unit();
  return {x, y, z};
}

// The slow twin: the solid angles of all triangles [Van Oosterom and Strackee 1983].
double slow_winding(const Triangles& s, const Point& p) {
  double total = 0;
  for (const Triangle& t : s.triangles) {
    const Point a = s.positions[t[0]] - p, b = s.positions[t[1]] - p, c = s.positions[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    total += 2 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return total / (4 * std::numbers::pi);
}

double box_distance(const Point& p, const Point& half) {
  const Eigen::Array3d out = p.array().abs() - half.array();
  return out.max(0).matrix().norm() + std::min(0.0, out.maxCoeff());
}

}  // namespace

TEST_CASE("distances to a box are exact at its edges, its corners, and in line with them") {
  const SignedDistance d(box({.size = {2, 4, 6}, .edge_length = 0.7}));
  for (int i = -6; i <= 6; ++i)
    for (int j = -10; j <= 10; ++j)
      for (int k = -14; k <= 14; ++k) {
        const Point p(0.25 * i, 0.25 * j, 0.25 * k);
        INFO(p.transpose());
        // Measured: at most 4.4e-16.
        REQUIRE(std::abs(d.at(p) - box_distance(p, {1, 2, 3})) <= 1e-15);
      }
}

TEST_CASE("distances to a ball of triangles are those to the ball but for the triangles' sagitta") {
  const double radius = 0.7, sagitta = 0.05 * 0.05 / (2 * radius);
  const SignedDistance d(sphere({.radius = radius, .edge_length = 0.05}));
  Dice dice(5);
  for (int i = 0; i < 3000; ++i) {
    const Point p = random_point(dice);
    const double off = d.at(p) - (p.norm() - radius);
    REQUIRE(off > -1e-12);
    REQUIRE(off < sagitta);
  }
}

TEST_CASE("signs are those of the winding number, on bodies that meet themselves too") {
  Triangles s = joined(cube(-0.5, 0.25), cube(-0.25, 0.5));
  s = joined(s, turned(cube(-0.125, 0.125)));
  s = joined(s, cube(0.25, 0.75));  // shares a corner, an edge's part and planes with the others
  const SignedDistance d(s);
  Dice dice(9);
  for (int i = 0; i < 3000; ++i) {
    const Point p = random_point(dice);
    const double winding = slow_winding(s, p);
    if (std::abs(d.at(p)) < 1e-9) continue;
    REQUIRE(d.winding(p) == std::lround(winding));
    REQUIRE((d.at(p) < 0) == (winding > 0.5));
  }
  CHECK(d.winding({0, 0, 0}) == 1);
  CHECK(d.winding({0.1875, 0.1875, 0.1875}) == 2);
  CHECK(d.winding({-0.4, 0.3, 0}) == 0);
}

TEST_CASE("slivers and triangles without area do not disturb the sign") {
  // A box whose sides are fans of slivers from points on, or a rounding beside, its own edges.
  Dice dice(11);
  Triangles s = cube(-0.5, 0.5);
  for (int round = 0; round < 400; ++round) {
    const auto at = static_cast<std::size_t>(dice.below(s.triangles.size()));
    const auto [a, b, c] = s.triangles[at];
    const double along = dice.uniform();
    const double beside = std::pow(10.0, dice.uniform(-18, -10));
    const Point edge = s.positions[a] + along * (s.positions[b] - s.positions[a]);
    const auto v = static_cast<std::uint32_t>(s.positions.size());
    s.positions.push_back(edge + beside * (s.positions[c] - edge));
    s.triangles[at] = {a, b, v};
    s.triangles.push_back({b, c, v});
    s.triangles.push_back({c, a, v});
  }
  const SignedDistance d(s);
  for (int i = 0; i < 4000; ++i) {
    Point p = random_point(dice);
    if (i % 2 == 0) {  // close to a vertex, where the slivers are
      const auto v = static_cast<std::size_t>(dice.below(s.positions.size()));
      p = s.positions[v] + std::pow(10.0, dice.uniform(-9, -1)) * p;
    }
    INFO(p.transpose());
    REQUIRE(std::abs(d.at(p) - box_distance(p, Point::Constant(0.5))) <= 1e-14);
  }
}

TEST_CASE("signed distances scale to the ends of the doubles, and are asked from anywhere") {
  for (const double scale : {0x1p-1000, 1.0, 0x1p1000}) {
    const SignedDistance d(stretched(cube(-1, 1), scale));
    CHECK(d.at({0, 0, 0}) == -scale);
    CHECK(d.at({0.5 * scale, 0, 0}) == -0.5 * scale);
    CHECK(d.at({4 * scale, 5 * scale, 0}) == 5 * scale);
    CHECK(d.at({-2 * scale, scale, -scale}) == scale);
  }
  CHECK(SignedDistance(cube(-1, 1)).at({-1e300, 0, 0}) == 1e300);
  CHECK_THROWS_AS(SignedDistance({}), InvalidInput);
}
