#include "surgery/detect/winding.h"

#include <catch2/catch.hpp>

#include "kernel/random.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

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
