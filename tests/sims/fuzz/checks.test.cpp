#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "sims/fuzz/checks.h"
#include "surgery/check/surgery_check.h"
#include "tests/sims/fuzz/healthy.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("no check objects to a healthy surgery") {
  const Healthy h;
  REQUIRE(h.surgery.outcome == Outcome::committed);
  REQUIRE(count_ties(h.before, lattice_of(h.before.positions, h.options)) == 0);
  for (const FuzzCheck& check : fuzz_checks()) {
    const Objection objection = check.object(h.seen());
    CAPTURE(check.name, objection.value_or(""));
    CHECK_FALSE(objection);
  }
}

TEST_CASE("names choose checks; unknown ones are refused, and sampling follows the seed") {
  const auto asked = [](const CheckChoice& choice, std::uint64_t seed) {
    std::string names;
    for (const FuzzCheck& check : fuzz_checks())
      if (choice.asks(check, seed)) names += std::string(names.empty() ? "" : ",") + check.name;
    return names;
  };
  CHECK(asked(CheckChoice("axes,audit"), 1) == "audit,axes");
  CHECK(asked(CheckChoice("fast"), 1) == "audit,bits,map,marches,invariance,settled");
  CHECK_THROWS_AS(CheckChoice("axes,tarot"), InvalidInput);
  CHECK_THROWS_AS(CheckChoice(""), InvalidInput);
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 6400; ++seed)
    all += asked(CheckChoice(), seed) == asked(CheckChoice("all"), seed) ? 1 : 0;
  CHECK(all > 60);
  CHECK(all < 150);
}
