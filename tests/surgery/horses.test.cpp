#include <catch2/catch.hpp>

#include "kernel/measure/self_intersections.h"
#include "tests/models.h"
#include "tests/surgery/exact_union.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

/// The classic horse turned outside out, or our animal where the scan is not at hand.
Triangles horse() {
  auto scan = classic("horse.ply");
  if (!scan) {
    WARN("horse.ply is not at hand (data/fetch_models brings it): an animal of our own stands in");
    return animal({Point::Zero(), 1, 0.035, 0.012});
  }
  for (Triangle& t : scan->triangles) std::swap(t[0], t[1]);
  return *scan;
}

}  // namespace

TEST_CASE("two horses become one body of the exact union's volume") {
  const Triangles first = horse();
  const Box box = bounding_box(first.positions);
  const Triangles second =
      translated(first, (box.high - box.low).cwiseProduct(Point(0.013, 0.007, 0.021)));
  const Triangles two = together(first, second);
  const double exact = exact_union_volume(first, second);
  const Box both = bounding_box(two.positions);
  for (const int cells : {64, 128, 192}) {
    Tracker tracker(two, {.cell_size = (both.high - both.low).maxCoeff() / cells});
    const SurgeryReport report = tracker.remodel();
    CAPTURE(cells, report.failure, volume(tracker.surface()) / exact - 1);
    CHECK(report.outcome == Outcome::committed);
    CHECK(audit(tracker.surface()).closed_manifold());
    if (cells == 64) continue;  // the legs are thinner than a cell there
    CHECK(report.components_after == 1);
    CHECK(report.euler_after == 2);
    CHECK(volume(tracker.surface()) == Approx(exact).epsilon(1e-3));
  }
}

TEST_CASE("with keep, every old vertex outside the region keeps its bits") {
  const Triangles first = horse();
  const Box box = bounding_box(first.positions);
  const Triangles two =
      together(first, translated(first, (box.high - box.low).cwiseProduct(Point(0.4, 0.3, 0.5))));
  Tracker tracker(two,
                  {.cell_size = (box.high - box.low).maxCoeff() / 100, .collapse = Collapse::keep});
  const SurgeryReport report = tracker.remodel();
  REQUIRE(report.outcome == Outcome::committed);
  CHECK(audit(tracker.surface()).closed_manifold());
  std::size_t kept = 0;
  for (std::uint32_t v = 0; v < two.positions.size(); ++v) {
    const std::uint32_t now = report.vertex_map[v];
    if (now == kNone) continue;
    ++kept;
    REQUIRE(tracker.surface().positions[now] == two.positions[v]);
  }
  CHECK(kept > two.positions.size() / 2);
  CHECK(kept < two.positions.size());
}
