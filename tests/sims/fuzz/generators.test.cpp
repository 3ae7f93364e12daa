#include <algorithm>
#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "sims/fuzz/generators.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("every generator makes closed oriented manifolds, whatever it draws") {
  for (const Generator& generator : generators())
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const bool large = seed % 20 == 0;
      const Triangles surface = generator.make(
          {Draws(seed), large ? 0.0625 : 0.25, large ? CaseSize::large : CaseSize::usual});
      const Audit result = audit(surface);
      CAPTURE(generator.name, seed, result.first);
      CHECK(result.closed_manifold());
      CHECK(surface.triangles.size() < (large ? 20000U : 1500U));
    }
}

TEST_CASE("generators are found by their names, and stand in alphabetical order") {
  std::vector<std::string> names;
  for (const Generator& generator : generators()) {
    CHECK(&generator_named(generator.name) == &generator);
    names.push_back(generator.name);
  }
  CHECK(names.size() >= 13);
  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK_THROWS_AS(generator_named("nothing"), InvalidInput);
}
