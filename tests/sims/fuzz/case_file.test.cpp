#include <catch2/catch.hpp>
#include <limits>

#include "kernel/errors.h"
#include "sims/fuzz/case_file.h"
#include "sims/fuzz/case_maker.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

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
