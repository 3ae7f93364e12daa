#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "sims/flows/fields.h"
#include "tests/extremes/bodies.h"

using namespace suture;
using namespace suture::surgery;
using namespace suture::sims;

TEST_CASE("what a remodel has settled stays settled over a hundred remodels, to the last bit") {
  Tracker tracker(two_balls(12), {.cell_size = 0.1});
  CHECK(tracker.remodel().outcome == Outcome::committed);
  const Triangles settled = tracker.surface();
  for (int i = 0; i < 100; ++i) {
    CHECK(tracker.remodel().outcome == Outcome::unchanged);
    REQUIRE(same_bits(tracker.surface(), settled));
  }
}

TEST_CASE("an improvement that finds nothing more to do keeps every bit and every index") {
  Tracker tracker(two_balls(12), {.cell_size = 0.1});
  tracker.remodel();
  for (int i = 0; i < 4; ++i) tracker.improve();
  const Triangles settled = tracker.surface();
  for (int i = 0; i < 10; ++i) {
    const QualityReport report = tracker.improve();
    tracker.remodel();
    REQUIRE(same_bits(tracker.surface(), settled));
    for (std::uint32_t v = 0; v < report.vertex_map.size(); ++v) CHECK(report.vertex_map[v] == v);
  }
}

TEST_CASE("time steps from 10^-12 to a throw across a hundred cells leave closed manifolds") {
  const std::vector<VelocityField> motions = {
      curl_noise({.seed = 3, .wavelength = 0.7}), rotation({.axis = Point(1, 2, 3)}),
      stretch({.axis = Point(1, 0.2, 0.1)}),
      [](const Point&, double) { return Point(1, 0.7, -0.9); }};
  for (std::size_t m = 0; m < motions.size(); ++m)
    for (const double dt : {1e-12, 1e-6, 1e-2, m == 3 ? 10.0 : 0.3}) {
      Tracker tracker(two_balls(6), {.cell_size = 0.1});
      CAPTURE(m, dt);
      for (int i = 0; i < 2; ++i) {
        tracker.advect(motions[m], dt);
        const SurgeryReport report = tracker.remodel();
        CHECK(report.outcome != Outcome::refused);
        tracker.improve();
        CHECK(audit(tracker.surface()).closed_manifold());
      }
      CHECK(tracker.time() == 2 * dt);
    }
}

TEST_CASE("vertices thrown at random by up to twenty cells are one tangle that surgery resolves") {
  for (const double reach : {1e-12, 0.1, 1.0, 10.0, 20.0}) {
    Tracker tracker(two_balls(2), {.cell_size = 0.1});
    Random random(5);
    std::vector<Point> to = tracker.surface().positions;
    for (Point& p : to)
      for (double& x : p) x += 0.1 * random.uniform(-reach, reach);
    tracker.displace(to);
    CAPTURE(reach);
    CHECK(tracker.remodel().outcome == Outcome::committed);
    CHECK(audit(tracker.surface()).closed_manifold());
    const double crumpled = edge_lengths(tracker.surface()).shortest;
    const QualityReport improved = tracker.improve();
    CHECK(improved.shortest_edge == Approx(edge_lengths(tracker.surface()).shortest));
    CHECK(improved.shortest_edge > crumpled);
    CHECK(audit(tracker.surface()).closed_manifold());
  }
}
