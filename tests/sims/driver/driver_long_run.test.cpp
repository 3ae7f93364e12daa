#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "sims/flows/fields.h"

using namespace suture;
using namespace suture::sims;

namespace {

struct Extremes {
  double smallest_angle = 180, shortest = 1e300, longest = 0;
  double worst_bad_share = 0;
  std::size_t remodelled = 0, refused = 0, most_components = 0, most_triangles = 0,
              not_manifold = 0;

  void see(const Tracker& tracker, const QualityReport& report) {
    const Triangles& surface = tracker.surface();
    most_triangles = std::max(most_triangles, surface.triangles.size());
    smallest_angle = std::min(smallest_angle, report.smallest_angle);
    shortest = std::min(shortest, report.shortest_edge);
    longest = std::max(longest, report.longest_edge);
    std::size_t bad = 0;
    for (const Triangle& t : surface.triangles)
      bad += angles({surface.positions, {t}}).smallest < 10 ? 1 : 0;
    worst_bad_share = std::max(
        worst_bad_share, static_cast<double>(bad) / static_cast<double>(surface.triangles.size()));
  }
};

}  // namespace

TEST_CASE("a thousand steps of curl noise with topology handled leave a good mesh throughout") {
  constexpr double kLength = 0.2;
  TrackerOptions options{.cell_size = 0.234};
  options.quality.edge_length = kLength;
  options.quality.keep_features = false;  // a fluid has none; creases that surgery leaves may go
  Tracker tracker(sphere({Point::Zero(), 1, kLength}), options);
  const VelocityField noise =
      curl_noise({.seed = 7, .wavelength = 2.5, .speed = 0.35, .period = 6, .radius = 2.5});
  Extremes seen;
  for (int n = 0; n < 1000; ++n) {
    tracker.advect(noise, 0.05);
    const SurgeryReport surgery = tracker.remodel();
    seen.remodelled += surgery.outcome == Outcome::committed ? 1 : 0;
    seen.refused += surgery.outcome == Outcome::refused ? 1 : 0;
    seen.most_components = std::max(seen.most_components, surgery.components_after);
    const QualityReport quality = tracker.improve();
    seen.not_manifold += audit(tracker.surface()).closed_manifold() ? 0 : 1;
    REQUIRE_FALSE(tracker.surface().triangles.empty());
    seen.see(tracker, quality);
  }
  WARN("angles down to " << seen.smallest_angle << " degrees, edges " << seen.shortest / kLength
                         << " to " << seen.longest / kLength << " lengths, at most "
                         << 100 * seen.worst_bad_share << " % of triangles below 10 degrees, "
                         << seen.remodelled << " of 1000 remodels changed topology, up to "
                         << seen.most_components << " components, " << seen.most_triangles
                         << " triangles, final volume " << volume(tracker.surface()));
  CHECK(seen.not_manifold == 0);
  CHECK(seen.refused == 0);
  CHECK(seen.remodelled > 0);
  // Seen: 0.5 degrees, 0.1 to 1.5 lengths, 1.2 % of triangles. The extremes are droplets of a dozen
  // triangles, smaller than an edge, and caps whose removal would move more volume than is allowed.
  CHECK(seen.smallest_angle > 0.05);
  CHECK(seen.shortest > 0.01 * kLength);
  CHECK(seen.longest < 2 * kLength);
  CHECK(seen.worst_bad_share < 0.03);
}
