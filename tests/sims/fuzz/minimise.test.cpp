#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/audit.h"
#include "sims/fuzz/case_file.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/execute.h"
#include "sims/fuzz/minimise.h"
#include "sims/fuzz/smaller.h"
#include "surgery/tracker.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

namespace {

const CheckChoice kFast("fast");

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
    const Minimised least = minimise(c, {planted, surface_before}, {.seconds = 60, .trials = 3000});
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
  const Minimised least = minimise(c, {planted, surface_before}, {.seconds = 60, .trials = 5});
  CHECK(least.trials <= 5);
  CHECK(planted(least.fuzz_case));
}
