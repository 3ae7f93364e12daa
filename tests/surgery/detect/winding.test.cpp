#include "surgery/detect/winding.h"

#include <catch2/catch.hpp>

#include "kernel/measure/nearest_triangle.h"
#include "kernel/random.h"
#include "surgery/detect/distance_field.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

Triangles tangle(std::uint64_t seed) {
  Random random(seed);
  Triangles body = ball(1, Point::Zero(), 4);
  for (Point& p : body.positions)
    p += Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  return body;
}

void check_windings(const Triangles& surface, double cell, std::uint64_t seed) {
  const Scan s = scan(surface, cell);
  CHECK(marches_agree(s.winding));
  Random random(seed);
  for (int n = 0; n < 60; ++n) {
    Index3 node;
    for (int a = 0; a < 3; ++a) node[a] = static_cast<int>(random.below(s.lattice.planes(a)));
    CAPTURE(seed, node[0], node[1], node[2]);
    for (int axis = 0; axis < 3; ++axis)
      CHECK(s.winding.at(node, axis) ==
            Approx(solid_angle_winding(surface, s.lattice.node(node))).margin(1e-6));
  }
}

}  // namespace

TEST_CASE("the marches along x, y and z agree with the solid angle at nodes in general position") {
  check_windings(ball(1), 0.173, 1);
  check_windings(torus({Point(0.01, 0.02, 0.03), 1, 0.4, 0.2}), 0.11, 2);
  check_windings(together(ball(1), ball(0.8, {0.7, 0.1, 0.2})), 0.137, 3);
  for (std::uint64_t seed = 0; seed < 20; ++seed) check_windings(tangle(seed), 0.21, seed);
}

TEST_CASE("the marches agree where every vertex, edge and face lies on planes, lines and nodes") {
  const Triangles cube = box({{0, 0, 0}, {2, 2, 2}, 0.5});
  for (const double cell : {0.25, 0.5, 1.0}) {
    const Scan s = scan(cube, cell);
    CHECK(marches_agree(s.winding));
    // The shifted lattice decides: a node at the lower face is inside, one at the upper face is
    // not.
    const int low = s.lattice.cell_of(0, -1.0) + 1, high = s.lattice.cell_of(0, 1.0) + 1;
    CHECK(s.winding.at({low, low, low}) == 1);
    CHECK(s.winding.at({high, low, low}) == 0);
    CHECK(s.winding.at({low, high, low}) == 0);
    CHECK(s.winding.at({low, low, high}) == 0);
  }
}

TEST_CASE("a body inside another counts twice, and a turned one counts minus one") {
  Triangles inner = ball(0.5);
  CHECK(scan(together(ball(1), inner), 0.1)
            .winding.at(
                scan(together(ball(1), inner), 0.1).lattice.cell_of(Point(0.05, 0.05, 0.05))) == 2);
  for (Triangle& t : inner.triangles) std::swap(t[0], t[1]);
  const Scan s = scan(inner, 0.1);
  CHECK(s.winding.at(s.lattice.cell_of(Point(0.05, 0.05, 0.05))) == -1);
}

TEST_CASE("filtered and rational arithmetic find the same crossings") {
  std::vector<Triangles> surfaces = {box({{0, 0, 0}, {2, 2, 2}, 0.5}), tangle(7), ball(1)};
  for (const Triangles& surface : surfaces) {
    const Scan a = scan(surface, 0.25), b = scan(surface, 0.25, Arithmetic::rational);
    REQUIRE(a.crossings.edge_crossings.size() == b.crossings.edge_crossings.size());
    for (std::size_t i = 0; i < a.crossings.edge_crossings.size(); ++i)
      REQUIRE(a.crossings.edge_crossings[i].face == b.crossings.edge_crossings[i].face);
    REQUIRE(a.crossings.line_crossings.size() == b.crossings.line_crossings.size());
    for (std::size_t i = 0; i < a.crossings.line_crossings.size(); ++i)
      REQUIRE(a.crossings.line_crossings[i].edge == b.crossings.line_crossings[i].edge);
  }
}

TEST_CASE(
    "D is the distance to the nearest triangle, signed by the winding, computed where asked") {
  const Triangles surface = ball(1, {0.03, 0.02, 0.01}, 6);
  const Scan s = scan(surface, 0.2);
  const DistanceField d(surface, s.lattice, s.winding);
  CHECK(d.nodes_computed() == 0);
  for (int i = 2; i < s.lattice.planes(0) - 2; ++i) {
    const Index3 node = {i, 7, 6};
    double nearest = 1e300;
    for (const Triangle& t : surface.triangles)
      for (const auto v : t)
        nearest = std::min(nearest, (surface.positions[v] - s.lattice.node(node)).norm());
    const double exact = (s.lattice.node(node) - Point(0.03, 0.02, 0.01)).norm() - 1;
    CHECK(d.at(node) == Approx(exact).margin(0.03));  // the mesh is within 0.03 of its sphere
    CHECK(std::abs(d.at(node)) <= nearest);
    CHECK((d.at(node) < 0) == s.winding.inside(node));
  }
  CHECK(d.nodes_computed() == static_cast<std::size_t>(s.lattice.planes(0) - 4));
}

TEST_CASE(
    "a tracker gives D at the nodes of surface cells, exact, and computes what is asked only") {
  const Triangles surface = tangle(3);
  const Tracker tracker(surface, {.cell_size = 0.3});
  const SurfaceDistance d = tracker.distance();
  CHECK(d.computed() == 0);
  const auto& nodes = d.surface_nodes();
  CHECK(nodes.size() > 200);
  CHECK(d.computed() == 0);
  for (std::size_t n = 0; n < nodes.size(); n += 5) {
    const Point at = d.lattice().node(nodes[n]);
    double nearest = 1e300;
    for (const Triangle& t : surface.triangles)
      nearest =
          std::min(nearest, distance_to_triangle(at, surface.positions[t[0]],
                                                 surface.positions[t[1]], surface.positions[t[2]]));
    CHECK(std::abs(d.at(nodes[n])) == nearest);
    CHECK((d.at(nodes[n]) < 0) == (solid_angle_winding(surface, at) > 0.5));
  }
  CHECK(d.computed() == (nodes.size() + 4) / 5);
}
