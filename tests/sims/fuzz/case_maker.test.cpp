#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "sims/fuzz/case_file.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/extrude.h"
#include "sims/fuzz/generators.h"
#include "sims/fuzz/operation_maker.h"
#include "sims/fuzz/checks.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("every generator makes closed oriented manifolds, whatever it draws") {
  for (const std::string& name : generator_names())
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      Random random(seed);
      const bool large = seed % 20 == 0;
      const Triangles surface = generate(name, {random, large ? 0.0625 : 0.25, large});
      const Audit result = audit(surface);
      CAPTURE(name, seed, result.first);
      CHECK(result.closed_manifold());
      CHECK(surface.triangles.size() < (large ? 20000U : 1500U));
    }
  Random random(1);
  CHECK_THROWS_AS(generate("nothing", {random, 0.25, false}), InvalidInput);
}

TEST_CASE("a seed gives the same case again, and another seed another one") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string one = to_toml({make_case(seed, {}), {}, {}});
    CHECK(one == to_toml({make_case(seed, {}), {}, {}}));
    CHECK(one != to_toml({make_case(seed + 1000, {}), {}, {}}));
  }
}

TEST_CASE("profiles, arithmetic, collapse and jitter are as asked for") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const FuzzCase c =
        make_case(seed, {Profile::fed_back, Arithmetic::rational, Collapse::keep, 0.001});
    CHECK(c.profile == "fed_back");
    CHECK(c.operations.size() >= 18);
    CHECK(c.options.arithmetic == Arithmetic::rational);
    CHECK(c.options.collapse == Collapse::keep);
    CHECK(c.options.jitter == 0.001);
  }
}

TEST_CASE("a case written to a file and read again is the same to the last bit") {
  const Folder folder;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CorpusCase c{make_case(seed, {}), "settled", "a cause with \"quotes\" and a \\"};
    c.fuzz_case.surface.positions[0] = {-0.0, std::numeric_limits<double>::denorm_min(),
                                        -std::numeric_limits<double>::max()};
    c.fuzz_case.surface.positions[1] = {1.0 / 3, 1e22, -5};
    const std::string text = to_toml(c);
    const CorpusCase again = read_case(folder.write("case.toml", text));
    CAPTURE(seed);
    CHECK(to_toml(again) == text);
    CHECK(same_bits(again.fuzz_case.surface, c.fuzz_case.surface));
    CHECK(again.fuzz_case.operations == c.fuzz_case.operations);
    CHECK(again.fuzz_case.options.cell_size == c.fuzz_case.options.cell_size);
    CHECK(again.fuzz_case.options.origin == c.fuzz_case.options.origin);
    CHECK(again.fuzz_case.seed == seed);
    CHECK(again.cause == c.cause);
  }
}

TEST_CASE("a file that is no case is refused with its place") {
  const Folder folder;
  const std::string good = to_toml({make_case(1, {}), {}, {}});
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
    CHECK_THROWS_AS(read_case(folder.write("bad.toml", text)), InvalidInput);
  };
  refused("[options]", "[opinions]");
  refused("positions = [", "positions = [1.0, ");
  refused("triangles = [", "triangles = [0.5, -1, 2, ");
  refused("seed = \"1\"", "seed = \"one\"");
  refused("cell_size", "cell_seize");
  refused("do = \"remodel\"", "do = \"rumble\"");
}

TEST_CASE("snapping puts coordinates exactly on planes, nudging one double beside them") {
  std::vector<Point> snapped, nudged;
  Random random(5);
  for (int i = 0; i < 50; ++i)
    snapped.push_back(Point{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)});
  nudged = snapped;
  const Point origin = Point::Constant(0.1);
  const Lattice lattice = lattice_around(bounding_box(snapped), 0.3, origin, 3);
  spoil(snapped, {Spoil::snap, 0, 1, 1}, 0.3, origin);
  spoil(nudged, {Spoil::nudge, 0, 1, 1}, 0.3, origin);
  for (std::size_t i = 0; i < snapped.size(); ++i)
    for (int a = 0; a < 3; ++a) {
      const double plane = lattice.plane(a, lattice.cell_of(a, snapped[i][a]) + 1);
      CHECK(snapped[i][a] == plane);
      CHECK(nudged[i][a] != plane);
      CHECK(std::nextafter(nudged[i][a], plane) == plane);
    }
}

TEST_CASE("a displacement survives its way through an operation") {
  const Spoiling s{Spoil::weld, 0.25, 0.5, 77};
  const Spoiling again = spoiling_of(displacement(s));
  CHECK(again.how == s.how);
  CHECK(again.amount == s.amount);
  CHECK(again.share == s.share);
  CHECK(again.seed == s.seed);
}
