#include "sims/fluid/liquid/liquid_bodies.h"

#include <catch2/catch.hpp>
#include <utility>

#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "tests/sims/fluid/liquids.h"

using namespace suture;
using namespace suture::sims;

namespace {

Triangles body(const Point& centre, double radius, double edge = 0.1) {
  return sphere({centre, radius, edge});
}

/// The ball inside out, which bounds a bubble.
Triangles bubble(const Point& centre, double radius, double edge = 0.1) {
  Triangles s = body(centre, radius, edge);
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

}  // namespace

TEST_CASE("a bubble belongs to the drop that it is in, and a drop in the bubble to nobody") {
  const Triangles s =
      merged(std::vector{bubble({0, 0, 0}, 0.6), body({0, 0, 0}, 1), body({0.1, 0, 0}, 0.3),
                         bubble({5, 0.1, 0}, 0.2), bubble({5, -0.4, 0}, 0.2), body({5, 0, 0}, 1)});
  const LiquidBodies bodies = liquid_bodies(s);
  REQUIRE(bodies.count == 3);
  const BodyMeasures m = measure(s, bodies);
  const auto of = [](const Triangles& t) { return volume(t); };
  CHECK(m.volume[0] == Approx(of(body({0, 0, 0}, 1)) - of(body({0, 0, 0}, 0.6))).epsilon(1e-13));
  CHECK(m.volume[1] == Approx(of(body({0.1, 0, 0}, 0.3))).epsilon(1e-13));
  CHECK(m.volume[2] ==
        Approx(of(body({5, 0, 0}, 1)) - 2 * of(body({5, 0, 0}, 0.2))).epsilon(1e-13));
  CHECK(m.area[1] == Approx(area(body({0.1, 0, 0}, 0.3))).epsilon(1e-13));
}

TEST_CASE("cells are of the body that they are in, where two are closer than a cell") {
  const Triangles s = merged(
      std::vector{sphere({Point(0, 0, 0), 4, 0.7}), sphere({Point(7.3, 0.9, 0.7), 3.2, 0.7})});
  const LiquidScene scene(s, 1);
  const LiquidBodies bodies = liquid_bodies(s);
  const std::vector<std::uint32_t> of_cell =
      bodies_of_cells(bodies, scene.exact.nearest(), scene.liquid);
  int touching = 0;
  for (Slot c = 0; c < of_cell.size(); ++c) {
    if (!scene.liquid.inside(c)) {
      REQUIRE(of_cell[c] == kNone);
      continue;
    }
    const bool first = scene.grid.centre(scene.grid.cell(c)).norm() < 4;
    REQUIRE(of_cell[c] == bodies.of_triangle[first ? 0 : bodies.of_triangle.size() - 1]);
    for (int a = 0; a < 3; ++a) {
      const Slot n = scene.grid.neighbour(c, a, 1);
      if (scene.liquid.inside(n) && of_cell[n] != kNone && of_cell[n] != of_cell[c]) ++touching;
    }
  }
  CHECK(touching > 0);
}
