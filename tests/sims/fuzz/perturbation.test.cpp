#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/lattice.h"
#include "kernel/random.h"
#include "sims/fuzz/perturbation.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("snapping puts coordinates exactly on planes, nudging one double beside them") {
  std::vector<Point> snapped, nudged;
  Random random(5);
  for (int i = 0; i < 50; ++i)
    snapped.push_back(Point{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)});
  nudged = snapped;
  const Point origin = Point::Constant(0.1);
  const Lattice lattice = lattice_around(bounding_box(snapped), 0.3, origin, 3);
  perturb(snapped, {Perturb::snap, 0, 1, 1}, {0.3, origin});
  perturb(nudged, {Perturb::nudge, 0, 1, 1}, {0.3, origin});
  for (std::size_t i = 0; i < snapped.size(); ++i)
    for (int a = 0; a < 3; ++a) {
      const double plane = lattice.plane(a, lattice.cell_of(a, snapped[i][a]) + 1);
      CHECK(snapped[i][a] == plane);
      CHECK(nudged[i][a] != plane);
      CHECK(std::nextafter(nudged[i][a], plane) == plane);
    }
}

TEST_CASE("every perturbation moves something, and does the same again") {
  std::vector<Point> before;
  Random random(7);
  for (int i = 0; i < 40; ++i)
    before.push_back(Point{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)});
  for (const auto& named : kPerturbNames) {
    std::vector<Point> once = before, again = before;
    perturb(once, {named.value, 0.4, 0.5, 11}, {0.3, Point::Constant(0.1)});
    perturb(again, {named.value, 0.4, 0.5, 11}, {0.3, Point::Constant(0.1)});
    CAPTURE(named.name);
    CHECK(once != before);
    CHECK(once == again);
  }
}
