#include <catch2/catch.hpp>
#include <cmath>

#include "sims/fuzz/twin_checks.h"
#include "surgery/check/surgery_check.h"
#include "tests/sims/fuzz/healthy.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("twins object to one bit of the surface, or one more event") {
  Healthy bit;
  for (Point& p : bit.after.positions)
    if (p[0] > 1) p[0] = std::nextafter(p[0], 9.0);
  for (const auto object : {check_rational, check_scaling, check_axes, check_order})
    CHECK(object(bit.seen()));
  Healthy event;
  ++event.surgery.marked.deep_inside;
  for (const auto object : {check_rational, check_scaling, check_axes, check_order})
    CHECK(object(event.seen()));
}

TEST_CASE("moved by whole cells, a surface meets the lattice as before") {
  Healthy h;  // with these numbers every move is exact
  h.options.cell_size = 0.25;
  for (Point& p : h.before.positions)
    for (int a = 0; a < 3; ++a) p[a] = std::round(p[a] * 0x1p20) * 0x1p-20;
  Tracker tracker(h.before, h.options);
  h.surgery = tracker.remodel();
  h.after = tracker.surface();
  CHECK_FALSE(check_cells(h.seen()));
  ++h.surgery.loops;
  CHECK(check_cells(h.seen()));
  --h.surgery.loops;
  h.after.positions[0][0] = std::nextafter(h.after.positions[0][0], 9.0);
  CHECK(check_cells(h.seen()));
}

TEST_CASE("ties are counted where vertices, edges and triangles meet planes, lines and nodes") {
  const Triangles off = sphere({Point(0.01, 0.02, 0.03), 1, 0.1, 3});
  TrackerOptions options;
  options.cell_size = 0.25;
  CHECK(count_ties(off, lattice_of(off.positions, options)) == 0);
  const Triangles on_planes = box({Point::Zero(), Point::Constant(1), 1});
  CHECK(count_ties(on_planes, lattice_of(on_planes.positions, options)) > 8);
}
