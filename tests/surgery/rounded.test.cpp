#include <catch2/catch.hpp>

#include "tests/surgery/hostile.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

struct Tally {
  int committed = 0, refused = 0;
};

/// Remodels each case under plain doubles; whatever comes of it, nothing but a closed manifold
/// stays.
Tally remodel_rounded(double jitter) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    HostileCase c = HostileCases(seed).make();
    c.options.arithmetic = Arithmetic::rounded;
    c.options.jitter = jitter;
    Tracker tracker(c.surface, c.options);
    const SurgeryReport report = tracker.remodel();
    CAPTURE(seed, report.failure);
    if (report.outcome != Outcome::committed) CHECK(tracker.surface() == c.surface);
    if (report.outcome == Outcome::refused) CHECK_FALSE(report.failure.empty());
    if (!tracker.surface().triangles.empty()) CHECK(audit(tracker.surface()).closed_manifold());
    tally.committed += report.outcome == Outcome::committed ? 1 : 0;
    tally.refused += report.outcome == Outcome::refused ? 1 : 0;
  }
  return tally;
}

}  // namespace

TEST_CASE("plain doubles are refused where they fail, and jitter makes them fail less often") {
  const Tally plain = remodel_rounded(0), moved = remodel_rounded(1e-6);
  WARN("rounded refused " << plain.refused << " of " << plain.refused + plain.committed
                          << " surgeries without jitter, " << moved.refused << " of "
                          << moved.refused + moved.committed << " with it");
  CHECK(plain.refused > 200);  // 266 of 357 seen
  CHECK(moved.refused < 20);   // 5 of 284 seen
  CHECK(moved.committed > 200);
}

TEST_CASE("in general position plain doubles find what exact signs find") {
  const Triangles two = together(ball(1, {0.013, 0.017, 0.011}), ball(0.8, {1.113, 0.207, 0.109}));
  TrackerOptions options{.cell_size = 0.1};
  Tracker exact(two, options);
  const SurgeryReport by_signs = exact.remodel();
  options.arithmetic = Arithmetic::rounded;
  options.jitter = 0;
  Tracker rounded(two, options);
  const SurgeryReport by_doubles = rounded.remodel();
  REQUIRE(by_doubles.outcome == Outcome::committed);
  CHECK(by_doubles.marked.total() == by_signs.marked.total());
  CHECK(rounded.surface().triangles == exact.surface().triangles);
}

TEST_CASE("jitter moves only what a remodel changes, by no more than was asked, and always alike") {
  const Triangles still = ball(1, {0.01, 0.02, 0.03});
  TrackerOptions options{.cell_size = 0.1, .arithmetic = Arithmetic::rounded, .jitter = 1e-3};
  Tracker one(still, options);
  CHECK(one.remodel().outcome == Outcome::unchanged);
  CHECK(one.surface() == still);

  const Triangles two = together(ball(1, {0.013, 0.017, 0.011}), ball(0.8, {1.113, 0.207, 0.109}));
  Tracker a(two, options), b(two, options);
  const SurgeryReport report = a.remodel();
  b.remodel();
  REQUIRE(report.outcome == Outcome::committed);
  CHECK(a.surface() == b.surface());
  double furthest = 0;
  for (std::size_t v = 0; v < two.positions.size(); ++v)
    if (report.vertex_map[v] != kNone)
      furthest = std::max(
          furthest,
          (a.surface().positions[report.vertex_map[v]] - two.positions[v]).cwiseAbs().maxCoeff());
  CHECK(furthest > 0);
  CHECK(furthest <= 1.001e-4);
}

TEST_CASE("jitter out of its range is refused") {
  for (const double jitter : {-1e-9, 0.2, std::nan("")})
    CHECK_THROWS_WITH(Tracker(ball(1), {.cell_size = 0.1, .jitter = jitter}),
                      Catch::Matchers::Contains("jitter"));
}
