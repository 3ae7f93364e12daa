#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "kernel/measure/self_intersections.h"
#include "tests/surgery/remodelled.h"

using namespace suture;
using namespace suture::surgery;

namespace {

/// Volume of the union of two balls of radii r and s whose centres are d apart.
double union_volume(double r, double s, double d) {
  const double lens = std::numbers::pi * (r + s - d) * (r + s - d) *
                      (d * d + 2 * d * (r + s) - 3 * (r - s) * (r - s)) / (12 * d);
  return 4.0 / 3 * std::numbers::pi * (r * r * r + s * s * s) - lens;
}

}  // namespace

TEST_CASE("two balls merge to one at every size and lattice offset") {
  int combinations = 0;
  for (const double radius : {1.0, 0.8, 0.55})
    for (const double offset : {0.0, 0.017, 0.031, 0.05, 0.0731}) {
      const Point at(1.1 + offset, 0.2, 0.1 + offset);
      const Triangles two = together(ball(1, Point::Constant(offset), 16), ball(radius, at, 16));
      const Remodelled r = remodelled(two, {.cell_size = 0.1});
      CAPTURE(radius, offset);
      CHECK(r.report.outcome == Outcome::committed);
      CHECK(r.report.components_after == 1);
      CHECK(r.report.euler_after == 2);
      const double exact = union_volume(1, radius, (at - Point::Constant(offset)).norm());
      CHECK(volume(r.surface) == Approx(exact).epsilon(0.01));  // frequency 16 alone loses 0.4 %
      ++combinations;
    }
  CHECK(combinations == 15);
}

TEST_CASE("the union of two balls converges to the exact one as cells shrink") {
  const Triangles two = together(ball(1, {0.013, 0.007, 0.003}, 64), ball(1, {1.2, 0.3, 0.1}, 64));
  const double exact = union_volume(1, 1, Point(1.187, 0.293, 0.097).norm());
  double last = 1;
  for (const int cells : {16, 32, 64}) {
    const Remodelled r = remodelled(two, {.cell_size = 3.2 / cells});
    const double error = std::abs(volume(r.surface) / exact - 1);
    CHECK(error < last);
    last = error;
  }
  CHECK(last < 1.5e-3);  // of which the icosphere itself is 0.02 %
}

TEST_CASE("a dumbbell whose neck is a tenth of a cell splits in two") {
  for (const double shift : {0.0, 0.04, 0.09}) {
    const Triangles body = dumbbell({{shift, 0.05, 0.03}, 0.5, 2.4, 0.005, 0.2, 0.05});
    const Remodelled r = remodelled(body, {.cell_size = 0.1});
    CAPTURE(shift);
    CHECK(r.report.components_after == 2);
    CHECK(r.report.euler_after == 4);
    CHECK(r.report.marked.deep_outside > 0);
    CHECK(remodelled(body, {.cell_size = 0.1, .events = Events::merge}).report.outcome ==
          Outcome::unchanged);
  }
}

TEST_CASE("without events nothing changes, to the last bit") {
  const Triangles two = together(ball(1), ball(0.8, {1.113, 0.207, 0.109}));
  const Remodelled r = remodelled(two, {.cell_size = 0.1, .events = Events::none});
  CHECK(r.report.outcome == Outcome::unchanged);
  CHECK(r.surface == two);
  for (std::uint32_t v = 0; v < two.positions.size(); ++v) REQUIRE(r.report.vertex_map[v] == v);
}

TEST_CASE("merge alone keeps a sheet thinner than a cell, split takes it apart") {
  const Triangles plate = sheet({{0.013, 0.011, 0.05}, 2, 1, 0.02, 0, 0.05});
  const Remodelled kept = remodelled(plate, {.cell_size = 0.1, .events = Events::merge});
  CHECK(kept.surface == plate);
  const Remodelled gone = remodelled(plate, {.cell_size = 0.1, .events = Events::split});
  CHECK(gone.report.marked.deep_outside > 0);
  CHECK(volume(gone.surface) < 0.5 * volume(plate));
}

TEST_CASE("split alone keeps two slightly overlapping bodies apart, merge joins them") {
  const Triangles two = together(ball(1, {0.01, 0.02, 0.03}), ball(1, {1.85, 0.02, 0.03}));
  CHECK(remodelled(two, {.cell_size = 0.1, .events = Events::split}).surface == two);
  CHECK(remodelled(two, {.cell_size = 0.1, .events = Events::merge}).report.components_after == 1);
}

TEST_CASE("a body that vanishes between the nodes leaves a valid surface, or none of it") {
  const Triangles pair = together(ball(1), ball(0.02, {3.05, 0.05, 0.05}, 2));
  const Remodelled r = remodelled(pair, {.cell_size = 0.1});
  CHECK(r.report.components_after == 1);
  CHECK(r.report.euler_after == 2);
}

TEST_CASE("boxes that share faces, edges and corners with the lattice merge as any others") {
  const Triangles cube = box({{0, 0, 0}, {1, 1, 1}, 0.25});
  for (const Point& by :
       std::vector<Point>{{0.5, 0, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.75}})
    for (const double cell : {0.0625, 0.125, 0.25}) {
      const Remodelled r = remodelled(together(cube, translated(cube, by)), {.cell_size = cell});
      CAPTURE(by.transpose(), cell);
      CHECK(r.report.components_after == 1);
      CHECK(r.report.euler_after == 2);
    }
}

TEST_CASE("a surface snapped onto the lattice is remodelled as any other") {
  for (const double cell : {0.125, 0.0625}) {
    Triangles two = together(ball(1, {0.01, 0.02, 0.03}, 8), ball(0.8, {1.113, 0.207, 0.109}, 8));
    for (Point& p : two.positions)
      for (int a = 0; a < 3; ++a) p[a] = std::round(p[a] / cell) * cell;
    const Remodelled r = remodelled(two, {.cell_size = cell});
    CHECK(r.report.components_after == 1);
  }
}

TEST_CASE("a remodelled surface stays as it is, to the last bit") {
  const std::vector<Triangles> inputs = {
      together(ball(1), ball(0.8, {1.113, 0.207, 0.109})),
      together(box({{0, 0, 0}, {1, 1, 1}, 0.25}), box({{0.5, 0.5, 0.5}, {1, 1, 1}, 0.25})),
      dumbbell({{0.01, 0.05, 0.03}, 0.5, 2.4, 0.005, 0.2, 0.05})};
  for (const Triangles& input : inputs)
    for (const Collapse collapse : {Collapse::straighten, Collapse::keep})
      for (const Placement placement : {Placement::distance_field, Placement::crossing}) {
        const TrackerOptions options{
            .cell_size = 0.1, .collapse = collapse, .placement = placement};
        const Remodelled first = remodelled(input, options);
        const Remodelled second = remodelled(first.surface, options);
        CHECK(second.report.outcome == Outcome::unchanged);
        CHECK(second.surface == first.surface);
      }
}

TEST_CASE("both arithmetics give the same surface, bit for bit") {
  const std::vector<Triangles> inputs = {
      together(ball(1, Point::Zero(), 6), ball(0.8, {1.113, 0.207, 0.109}, 6)),
      together(box({{0, 0, 0}, {1, 1, 1}, 0.25}), box({{0.5, 0.5, 0.25}, {1, 1, 1}, 0.25})),
      dumbbell({{0.01, 0.05, 0.03}, 0.5, 2.4, 0.005, 0.2, 0.1})};
  for (const Triangles& input : inputs)
    for (const Collapse collapse : {Collapse::straighten, Collapse::keep}) {
      TrackerOptions options{.cell_size = 0.125, .collapse = collapse};
      const Remodelled filtered = remodelled(input, options);
      options.arithmetic = Arithmetic::rational;
      const Remodelled rational = remodelled(input, options);
      CHECK(filtered.report.outcome == Outcome::committed);
      CHECK(filtered.surface == rational.surface);
    }
}

TEST_CASE("a refused option is named") {
  const Triangles body = ball(1);
  for (const double cell : {0.0, -1.0, std::nan(""), 1e-12})
    CHECK_THROWS_AS(Tracker(body, {.cell_size = cell}), InvalidInput);
  CHECK_THROWS_WITH(Tracker(body, {.cell_size = 4e-6}), Catch::Matchers::Contains("GB"));
  CHECK_THROWS_AS(Tracker(body, {.cell_size = 0.1, .depth = -1}), InvalidInput);
  CHECK_THROWS_AS(Tracker(Triangles{}, {.cell_size = 0.1}), InvalidInput);
}

TEST_CASE("the plain test re-samples more than the deep test does") {
  const Triangles two =
      together(ball(1, {0.01, 0.02, 0.03}, 16), ball(0.8, {1.113, 0.207, 0.109}, 16));
  const Remodelled deep = remodelled(two, {.cell_size = 0.1});
  const Remodelled plain = remodelled(two, {.cell_size = 0.1, .cell_test = CellTest::plain});
  CHECK(plain.report.marked.total() > deep.report.marked.total());
  CHECK(plain.report.components_after == 1);
}

TEST_CASE("surgery takes self-intersections away") {
  const Triangles two =
      together(ball(1, {0.013, 0.017, 0.011}, 16), ball(0.8, {1.113, 0.207, 0.109}, 16));
  REQUIRE(self_intersections(two).pairs.size() > 100);
  CHECK(self_intersections(remodelled(two, {.cell_size = 0.1}).surface).pairs.empty());
}

TEST_CASE("an exact copy is dropped, unless a cavity tells the copies apart") {
  const Triangles solid = ball(1, {0.01, 0.02, 0.03});
  Triangles cavity = ball(0.5, {0.01, 0.02, 0.03});
  for (Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  const Triangles hollow = together(solid, cavity);
  const Remodelled twice = remodelled(together(solid, solid), {.cell_size = 0.1});
  CHECK(twice.report.coincident_triangles == solid.triangles.size());
  CHECK(twice.surface == solid);
  CHECK(remodelled(together(hollow, hollow), {.cell_size = 0.1}).report.components_after == 2);

  const Remodelled filled = remodelled(together(solid, hollow), {.cell_size = 0.1});
  CHECK(filled.report.components_after == 1);
  CHECK(volume(filled.surface) == Approx(volume(solid)).epsilon(0.02));

  const Remodelled thicker = remodelled(
      together(hollow, together(ball(1.3, {0.01, 0.02, 0.03}), cavity)), {.cell_size = 0.1});
  CHECK(thicker.report.components_after == 2);  // both have the cavity, and so has their union
}

TEST_CASE(
    "the same bodies merge alike at every scale that squares and cubes of lengths would leave") {
  const Triangles two =
      together(ball(1, {0.01, 0.02, 0.03}, 6), ball(0.8, {1.113, 0.207, 0.109}, 6));
  for (const Collapse collapse : {Collapse::straighten, Collapse::keep}) {
    const Remodelled one = remodelled(two, {.cell_size = 0.125, .collapse = collapse});
    for (const int power : {-200, -60, 60, 150}) {
      const Remodelled other =
          remodelled(scaled(two, std::ldexp(1.0, power)),
                     {.cell_size = std::ldexp(0.125, power), .collapse = collapse});
      CAPTURE(power);
      CHECK(other.surface == scaled(one.surface, std::ldexp(1.0, power)));
    }
    for (const int power : {-600, 300, 500})
      CHECK(remodelled(scaled(two, std::ldexp(1.0, power)),
                       {.cell_size = std::ldexp(0.125, power), .collapse = Collapse::keep})
                .report.components_after == 1);
  }
}

TEST_CASE("long triangles across many cells are cut in time that follows their crossings") {
  const Triangles spike{{{0, 0, 0}, {0, 1, 0}, {0, 0.5, 1}, {100, 0.5, 0.5}},
                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const Triangles slanted{
      {{0.013, 0.01, 0.02}, {0.013, 1.013, 0.017}, {0.113, 0.47, 1.03}, {100, 50.51, 33.52}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  for (const Triangles& body : {spike, slanted}) {
    const Remodelled r = remodelled(body, {.cell_size = 0.2});
    CHECK(r.report.outcome == Outcome::committed);
    CHECK(r.surface.triangles.size() < 2000);
  }
}
