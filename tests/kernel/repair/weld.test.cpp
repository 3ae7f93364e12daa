// Equal points beside a search through all of them.
#include "kernel/repair/weld.h"

#include <catch2/catch.hpp>
#include <limits>

#include "kernel/random.h"

using namespace suture;

TEST_CASE("each point finds the first that equals it, as a search through all does") {
  Random random(2);
  std::vector<Point> points;
  for (int n = 0; n < 500; ++n) {
    Point p;
    for (double& x : p) x = static_cast<double>(random.below(4)) - 2;
    points.push_back(p);
  }
  const std::vector<std::uint32_t> first = first_equal(points);
  std::size_t repeated = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t expected = 0;
    while (points[expected] != points[i]) ++expected;
    CHECK(first[i] == expected);
    repeated += expected != i ? 1 : 0;
  }
  CHECK(repeated > 400);
}

TEST_CASE("both zeros are one point, and NaN equals nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point> points{{0, 1, 2}, {-0.0, 1, 2}, {nan, 0, 0}, {nan, 0, 0}};
  CHECK(first_equal(points) == std::vector<std::uint32_t>{0, 0, 2, 3});
}
