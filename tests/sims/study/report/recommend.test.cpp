// A study's table in words.
#include "sims/study/report/recommend.h"

#include <catch2/catch.hpp>

#include "tests/sims/study/trade_rows.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

TEST_CASE("the recommendation names the best, the cheaper that is as good, and what fails") {
  const std::vector<Row> rows = planted_study();
  CHECK(run_number(*least_error(rows)) == 5);
  CHECK(run_number(*as_good_for_less(rows, rows[2])) == 4);
  std::vector<Row> crossed = rows;
  crossed[3].set("self_intersecting_pairs",
                 1.0);  // as near and cheaper, but it passes through itself
  CHECK(run_number(*as_good_for_less(crossed, crossed[2])) == 3);
  CHECK(run_number(*as_good_for_less(rows, rows[0])) == 1);
  const std::string page =
      recommendation(rows, {.title = "A scene", .reference = "a file", .cell_size = 0.1});
  CHECK_THAT(page, Contains("smallest error: `passes=5` (run 5): mean distance 1 cells") &&
                       Contains("at the least cost: `passes=4` (run 4)") &&
                       Contains("least seconds: `passes=1` (run 1)"));
  CHECK_THAT(page, Contains("run 7, `passes=7`: 2 of 7 remodels were refused, the first because") &&
                       Contains("run 8, `passes=8`: crashed: killed by signal 11") &&
                       Contains("3 components, Euler characteristic 2: runs 6"));
}

TEST_CASE("a study without a sound run recommends nothing") {
  std::vector<Row> rows = {planted(1, 1, 0.1, "own"), planted_crash(2, 1)};
  rows[0].set("topology_right", 0.0);
  CHECK(least_error(rows) == nullptr);
  CHECK_THAT(recommendation(rows, {"A scene", "a file"}), Contains("Nothing can be recommended"));
}
