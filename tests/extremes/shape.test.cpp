#include <catch2/catch.hpp>

#include "tests/extremes/bodies.h"

using namespace suture;
using namespace suture::surgery;

namespace {

struct Run {
  Triangles remodelled, improved;
  SurgeryReport report;
};

/// Remodels and improves, and audits after each.
Run run(const Triangles& surface, double cell) {
  Tracker tracker(surface, {.cell_size = cell});
  Run result;
  result.report = tracker.remodel();
  INFO(result.report.failure);
  CHECK(result.report.outcome != Outcome::refused);
  result.remodelled = tracker.surface();
  tracker.improve();
  result.improved = tracker.surface();
  for (const Triangles* s : {&result.remodelled, &result.improved}) {
    const Audit a = audit(*s);
    INFO(a.first);
    CHECK(a.closed_manifold());
  }
  return result;
}

}  // namespace

TEST_CASE("one tetrahedron between the nodes goes, one across a few cells loses its tips only") {
  CHECK(run(corner_tetrahedron({0.1, 0.1, 0.1}, 0.5), 1).remodelled.triangles.empty());
  const Triangles large = corner_tetrahedron({0.1, 0.2, 0.3}, 6.3);
  const Run r = run(large, 1);
  CHECK(volume(r.remodelled) <= volume(large));
  CHECK(volume(r.remodelled) > 0.6 * volume(large));
}

TEST_CASE("slivers of aspect up to 10^15 do not change what is merged") {
  const double usual = volume(run(with_slivers(two_balls(12), 1e-3), 0.1).improved);
  for (const double aspect : {1e6, 1e9, 1e12, 1e15}) {
    const Run r = run(with_slivers(two_balls(12), 1 / aspect), 0.1);
    CAPTURE(aspect);
    CHECK(r.report.components_after == 1);
    CHECK(volume(r.improved) == Approx(usual).epsilon(1e-4));
    CHECK(angles(r.improved).smallest > 0);
  }
}

TEST_CASE("bodies flattened or drawn out by 10^12 stay closed manifolds") {
  for (const double thin : {1e-6, 1e-12})
    for (const Point& by : {Point(1, 1, thin), Point(1, thin, thin)}) {
      const Run r = run(scaled(two_balls(), by), 0.1);
      CAPTURE(thin);
      CHECK(r.report.outcome == Outcome::committed);
      CHECK(volume(r.remodelled) <= r.report.volume_before);
    }
}

TEST_CASE("closed surfaces without volume, in a plane, on a line or in a point, vanish or stay") {
  for (const int axes : {2, 1, 0}) {
    Triangles surface = two_balls();
    for (Point& p : surface.positions)
      for (int a = axes; a < 3; ++a) p[a] = 0.3;
    const Run r = run(surface, 0.1);
    CAPTURE(axes);
    CHECK(volume(r.remodelled) == 0);
    CHECK(volume(r.improved) == 0);
  }
  for (const double height : {0.25, 0.3}) {  // on a plane of the lattice, and between two
    Triangles two = together(pillow(8, 3), translated(pillow(8, 3), {0.5, 0.4, 0}));
    for (Point& p : two.positions) p[2] = height;
    REQUIRE(audit(two).closed_manifold());
    CHECK(volume(run(two, 0.25).improved) == 0);
  }
}

TEST_CASE(
    "every vertex on a node of the lattice, with edges and faces along its lines and planes") {
  Triangles surface = two_balls(12);
  for (Point& p : surface.positions)
    for (double& x : p) x = 0.125 * std::round(8 * x);
  const Run r = run(surface, 0.125);
  CHECK(r.report.components_after == 1);
  // The union of the two balls is 9.7 % below their sum.
  CHECK(volume(r.remodelled) == Approx(0.903 * r.report.volume_before).epsilon(0.01));
}

TEST_CASE("five hundred triangles round one vertex are cut, straightened and improved") {
  const Triangles cone = double_cone(500);
  const Run r = run(together(cone, translated(cone, {0.21, 0.13, 0.07})), 0.1);
  CHECK(r.report.components_after == 1);
  CHECK(volume(r.improved) > volume(cone));
  CHECK(volume(r.improved) < 1.4 * volume(cone));
}
