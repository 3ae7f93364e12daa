// Isosurfaces of a ball's distance: closed, on the ball, and refused where the box is too small.
#include "kernel/isosurface/isosurface.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/measure/self_intersections.h"

using namespace suture;

namespace {

double from_ball(const Point& p) { return p.norm() - 1; }

}  // namespace

TEST_CASE("the zero surface of a ball's distance is a closed embedded sphere on the ball") {
  const Box box{Point::Constant(-1.3), Point::Constant(1.3)};
  const Triangles ball = isosurface(from_ball, box, 0.13);
  CHECK(audit(ball).closed_manifold());
  CHECK(euler_characteristic(ball) == 2);
  CHECK(self_intersections(ball).pairs.empty());
  CHECK(volume(ball) == Approx(4 * std::numbers::pi / 3).epsilon(0.02));
  double farthest = 0;
  for (const Point& p : ball.positions) farthest = std::max(farthest, std::abs(from_ball(p)));
  CHECK(farthest < 1e-3 * 0.13 * 2);  // vertices are kept a thousandth of an edge off its ends
}

TEST_CASE("a node with the value 0 counts as outside, and the surface stays closed") {
  const Box box{Point::Constant(-2), Point::Constant(2)};
  const Triangles ball = isosurface(from_ball, box, 1);  // six nodes lie on the ball
  CHECK(audit(ball).closed_manifold());
  CHECK(volume(ball) > 0);
}

TEST_CASE("a box that is too small or takes too many nodes is refused") {
  CHECK_THROWS_WITH(isosurface(from_ball, {Point::Constant(-0.9), Point::Constant(2)}, 0.1),
                    Catch::Contains("border"));
  CHECK_THROWS_WITH(isosurface(from_ball, {Point::Constant(-2), Point::Constant(2)}, 1e-4),
                    Catch::Contains("too many nodes"));
}
