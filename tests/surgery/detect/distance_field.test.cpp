#include "surgery/detect/distance_field.h"

#include <catch2/catch.hpp>

#include "kernel/measure/nearest_triangle.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

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
