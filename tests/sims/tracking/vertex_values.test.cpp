#include "sims/tracking/vertex_values.h"

#include <catch2/catch.hpp>

#include "tests/sims/balls.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("values are carried to where vertices went and spread to new ones") {
  const Triangles ball = subdivided_ball(0, 1);  // an octahedron
  const std::vector<double> old_values = {4, 8, 1};
  const std::vector<std::uint32_t> map = {0, 0, kNone};
  const std::vector<double> values = carried(old_values, 0.0, ball, map);
  for (const double value : values) CHECK(value == 6);
  CHECK(carried(std::vector<double>(6, 2.0), 0.0, ball, {}) == std::vector<double>(6, 2.0));
}
