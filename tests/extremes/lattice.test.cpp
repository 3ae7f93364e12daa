#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "tests/extremes/bodies.h"
#include "tests/surgery/remodelled.h"

using namespace suture;
using namespace suture::surgery;

TEST_CASE("in cells far larger than it a body stays if it holds a node, and goes if it does not") {
  for (const double cell : {1e200, 100.0, 4.0}) {
    CAPTURE(cell);
    Tracker tracker(two_balls(), {.cell_size = cell});  // the origin is inside of both
    CHECK(tracker.remodel().outcome == Outcome::unchanged);
    tracker.improve();
    CHECK(audit(tracker.surface()).closed_manifold());
    Tracker between(translated(two_balls(), Point::Constant(1.5)), {.cell_size = cell});
    CHECK(between.remodel().outcome == Outcome::committed);
    CHECK(between.surface().triangles.empty());
    between.improve();
    CHECK(between.remodel().outcome == Outcome::unchanged);
    between.advect([](const Point& p, double) { return p; }, 1);
    CHECK(between.time() == 1);
  }
}

TEST_CASE("bodies in opposite corners of a lattice of 2^62 cells are remodelled as one alone is") {
  const auto pair = [](const Point& at) {
    return together(corner_tetrahedron(at, 6.25),
                    corner_tetrahedron(at + Point(1.25, 1.375, 1.5), 6.25));
  };
  const Triangles near = pair(Point::Constant(0.125));
  const double far = 0x1p21 - 19;  // the largest lattice: 2^21 − 3 cells along each axis
  const Remodelled one = remodelled(near, {.cell_size = 1});
  const Remodelled both =
      remodelled(together(near, translated(near, Point::Constant(far))), {.cell_size = 1});
  CHECK(one.report.components_after == 1);
  CHECK(both.report.components_after == 2);
  CHECK(both.report.surface_cells == 2 * one.report.surface_cells);
  CHECK(both.surface.triangles.size() == 2 * one.surface.triangles.size());
  // Far away a position has 32 binary digits behind the point instead of 50.
  CHECK(volume(both.surface) == Approx(2 * volume(one.surface)).epsilon(1e-8));
  const Triangles beyond = together(near, translated(near, Point::Constant(far + 1)));
  CHECK_THROWS_WITH(Tracker(beyond, {.cell_size = 1}),
                    Catch::Contains("2097150 cells") && Catch::Contains("at most 2097149 fit"));
}

TEST_CASE("cells too many for the indices or the memory are refused before they are made") {
  CHECK_THROWS_WITH(Tracker(two_balls(), {.cell_size = 1e-7}), Catch::Contains("fit the indices"));
  CHECK_THROWS_WITH(Tracker(two_balls(), {.cell_size = 1e-200}),
                    Catch::Contains("fit the indices"));
  CHECK_THROWS_WITH(Tracker(two_balls(), {.cell_size = 3e-6}),
                    Catch::Contains("crossings can be numbered"));
}

TEST_CASE("a surface in every cell of the lattice is re-sampled in all of them") {
  const Triangles surface = gyroid(6, 0.34);
  const Remodelled r =
      remodelled(surface, {.cell_size = 1, .cell_test = CellTest::plain, .depth = 0});
  CHECK(r.report.surface_cells >= 6 * 6 * 6);
  CHECK(r.report.outcome == Outcome::committed);
  CHECK(r.report.marked.total() > r.report.surface_cells / 2);
}

TEST_CASE("triangles across thousands of cells are cut in time that follows their length") {
  const auto bars = [](double length) {
    const Point size(length, 2.3, 2.3);
    const auto bar = [&](const Point& at) { return box({at + size / 2, size, 4 * length}); };
    return together(bar({0.1, 0.2, 0.3}), bar({0.4, 0.8, 1.4}));
  };
  const Remodelled shorter = remodelled(bars(500), {.cell_size = 1});
  const Remodelled longer = remodelled(bars(2000), {.cell_size = 1});
  CHECK(longer.report.components_after == 1);
  CHECK(volume(longer.surface) == Approx(2 * 2000 * 2.3 * 2.3 - 1999.7 * 1.7 * 1.2).epsilon(0.01));
  // What is left must not cross the lattice as often as the square of the length either.
  const Remodelled again = remodelled(longer.surface, {.cell_size = 1}),
                   was = remodelled(shorter.surface, {.cell_size = 1});
  CHECK(again.report.crossings < 5 * was.report.crossings);
}
