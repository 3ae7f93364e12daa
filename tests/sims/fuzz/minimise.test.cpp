#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "sims/fuzz/case_file.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/corpus.h"
#include "sims/fuzz/execute.h"
#include "sims/fuzz/smaller.h"
#include "surgery/tracker.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

namespace {

const OracleChoice kFast("fast");

Triangles surface_before(const FuzzCase& c, std::size_t operation) {
  Triangles found;
  run_case(c, kFast, [&](std::size_t index, const Triangles& surface) {
    if (index == operation) found = surface;
  });
  return found;
}

/// A planted fault: a remodel "fails" where a vertex of what it is given lies above x = 0.4 and
/// another one below x = 0, and something is re-sampled.
bool planted(const FuzzCase& c) {
  bool fails = false;
  Triangles given;
  std::size_t at = 0;
  run_case(c, kFast, [&](std::size_t index, const Triangles& surface) {
    at = index;
    given = surface;
    if (c.operations[at].kind != Operation::Kind::remodel) return;
    double low = 1, high = -1;
    for (const Point& p : surface.positions) {
      low = std::min(low, p[0]);
      high = std::max(high, p[0]);
    }
    Tracker tracker(surface, c.options);
    fails |= low < 0 && high > 0.4 && tracker.remodel().outcome == Outcome::committed;
  });
  return fails;
}

std::size_t bits_of(const Triangles& surface) {
  std::size_t bits = 0;
  for (const Point& p : surface.positions)
    for (int a = 0; a < 3; ++a)
      for (int n = 1; n <= 53; ++n)
        if (rounded_to_bits(p[a], n) == p[a]) {
          bits += static_cast<std::size_t>(n);
          break;
        }
  return bits;
}

}  // namespace

TEST_CASE("a failing case becomes a few triangles, one operation and round numbers") {
  int tried = 0;
  for (std::uint64_t seed = 1; tried < 3 && seed < 100; ++seed) {
    const FuzzCase c = make_case(seed, {Profile::random});
    if (c.surface.triangles.size() < 60 || c.operations.size() < 5 || !planted(c)) continue;
    ++tried;
    const Minimised least = minimise(c, planted, surface_before, {.seconds = 60, .trials = 3000});
    const FuzzCase& m = least.fuzz_case;
    CAPTURE(seed, c.generator, m.surface.triangles.size(), least.trials);
    CHECK(planted(m));
    CHECK(audit(m.surface).closed_manifold());
    CHECK(m.operations.size() == 1);
    CHECK(m.surface.triangles.size() <= 20);  // a torus cannot have fewer than 14
    CHECK(bits_of(m.surface) <= 12 * 3 * m.surface.positions.size());
    CHECK(least.trials <= 3000);

    const Folder folder;
    const CorpusCase again =
        read_case(folder.write("least.toml", to_toml({m, "planted", "a planted fault"})));
    CHECK(planted(again.fuzz_case));
  }
  CHECK(tried == 3);
}

TEST_CASE("the minimiser stays within its trials, and what it returns still fails") {
  std::uint64_t seed = 1;
  while (!planted(make_case(seed, {Profile::random}))) ++seed;
  const FuzzCase c = make_case(seed, {Profile::random});
  const Minimised least = minimise(c, planted, surface_before, {.seconds = 60, .trials = 5});
  CHECK(least.trials <= 5);
  CHECK(planted(least.fuzz_case));
}

TEST_CASE("a component is left out, or gives way to a tetrahedron or a box of the same sign") {
  const FuzzCase c = make_case(3, {Profile::random});
  const Triangles two = c.surface;
  const std::size_t count = components(two).count;
  CHECK(components(without_component(two, 0)).count == count - 1);
  for (const Stand stand : {Stand::tetrahedron, Stand::box}) {
    const Triangles other = component_replaced(two, 0, stand);
    REQUIRE_FALSE(other.triangles.empty());
    CHECK(audit(other).closed_manifold());
    CHECK(components(other).count == count);
    CHECK(other.triangles.size() < two.triangles.size());
  }
}

TEST_CASE("edges collapse until a tetrahedron is left, closed and manifold throughout") {
  Triangles surface = make_case(7, {Profile::random}).surface;
  for (std::size_t t = 0; t < surface.triangles.size();)
    t = collapse_edge(surface, t, 0) ? 0 : t + 1;
  CHECK(audit(surface).closed_manifold());
  CHECK(surface.triangles.size() >= 4 * components(surface).count);
  CHECK(surface.triangles.size() <= 40 * components(surface).count);
}

TEST_CASE("numbers are rounded to so many bits") {
  CHECK(rounded_to_bits(0.3, 1) == 0.25);
  CHECK(rounded_to_bits(-5.3, 3) == -5);
  CHECK(rounded_to_bits(0, 3) == 0);
  CHECK(rounded_to_bits(0x1p-1074, 4) == 0x1p-1074);
  CHECK(rounded_to_bits(0.1, 53) == 0.1);
}

TEST_CASE("a case is run in a child of its own, which may crash or hang") {
  FuzzCase c = make_case(1, {});
  CHECK_FALSE(failure_of(c, kFast, 60));
  c.surface = sphere({Point::Zero(), 1, 0.1, 40});  // takes longer than a millisecond
  const auto slow = failure_of(c, kFast, 1e-9);
  REQUIRE(slow);
  CHECK(slow->oracle == "hang");
  c.operations.assign(1, {Operation::Kind::displace, {}});
  const auto thrown = failure_of(c, kFast, 60);  // "how" is missing
  REQUIRE(thrown);
  CHECK(thrown->oracle == "exception");
}

TEST_CASE("failures are saved, named in the summary, and fail again when they are replayed") {
  const Folder folder;
  FuzzSummary summary;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    summary.failures.push_back({seed, "hang", "took more than 0 s", {}});

  save_failures(summary, folder / "corpus", kFast, {.seconds = 0.5, .trials = 10, .each = 2},
                [](std::uint64_t seed) { return make_case(seed, {}); });
  CHECK(folder.files() == 3);  // the folder and two cases
  CHECK(summary.failures[2].file.empty());
  const CorpusCase kept = read_case(summary.failures[0].file);
  CHECK(kept.oracle == "hang");
  CHECK(kept.fuzz_case.seed == 1);
}
