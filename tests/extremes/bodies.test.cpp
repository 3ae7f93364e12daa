#include <catch2/catch.hpp>

#include "tests/extremes/bodies.h"

using namespace suture;
using namespace suture::surgery;

namespace {

struct Run {
  Triangles surface;
  SurgeryReport report;
};

Run run(const Triangles& surface, double cell) {
  Tracker tracker(surface, {.cell_size = cell});
  SurgeryReport report = tracker.remodel();
  INFO(report.failure);
  CHECK(report.outcome != Outcome::refused);
  CHECK(audit(tracker.surface()).closed_manifold());
  return {tracker.surface(), std::move(report)};
}

}  // namespace

TEST_CASE("ten thousand bodies apart keep every bit") {
  const Triangles apart = ball_grid(10000, 0.4, 1);
  const Run stays = run(apart, 0.3);
  CHECK(stays.report.outcome == Outcome::unchanged);
  CHECK(stays.report.components_before == 10000);
  CHECK(same_bits(stays.surface, apart));
}

TEST_CASE("a chain of two thousand bodies, each into the next, is one body after one remodel") {
  std::vector<Triangles> all;
  for (int i = 0; i < 2000; ++i)
    all.push_back(corner_tetrahedron({i + 0.13, 0.07 + 0.1 * (i % 2), 0.03}, 3));
  const Run r = run(merged(all), 0.6);
  CHECK(r.report.components_before == 2000);
  CHECK(r.report.components_after == 1);
}

TEST_CASE("a body inside a body inside a body leaves the outermost, to the last bit") {
  for (const int count : {2, 3, 8}) {
    const Run r = run(nested(count, false), 0.05);
    CAPTURE(count);
    CHECK(r.report.components_after == 1);
    CHECK(volume(r.surface) == volume(ball(1, Point(0.013, 0.007, 0.003), 8)));
  }
}

TEST_CASE("cavities with bodies in them with cavities in them stay, to the last bit") {
  for (const int count : {2, 3, 8}) {
    const Triangles surface = nested(count, true);
    CHECK(same_bits(run(surface, 0.05).surface, surface));
  }
}
