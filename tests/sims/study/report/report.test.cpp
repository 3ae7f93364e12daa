// What is made of a study's rows: the table, the front, the words.
#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/errors.h"
#include "sims/study/report/front.h"
#include "sims/study/report/plot.h"
#include "sims/study/report/recommend.h"
#include "sims/study/table/trade_row.h"
#include "tests/sims/cli/program.h"
#include "tests/sims/study/trade_rows.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

namespace {

/// The cheapest (1), one that another beats (2), the scene's own (3), a better and cheaper one than
/// that (4), the best (5), and a better one still with the wrong topology (6), refused (7), lost
/// (8).
std::vector<Row> study() {
  std::vector<Row> rows = {planted(1, 1, 0.8),  planted(2, 2, 0.9), planted(3, 4, 0.4, "own"),
                           planted(4, 3, 0.3),  planted(5, 9, 0.1), planted(6, 2, 0.01, "passes"),
                           planted(7, 2, 0.01), planted_crash(8, 5)};
  rows[5].figures.topology_right = 0;
  rows[5].figures.components = 3;
  rows[6].outcome = kRefusedRun;
  rows[6].failure = "cut: \"an edge\", twice\nused";
  rows[6].figures.refused = 2;
  rows[6].figures.remodels = 7;
  return rows;
}

std::vector<int> numbers(const std::vector<Row>& rows, const std::vector<std::size_t>& indices) {
  std::vector<int> runs;
  for (const std::size_t i : indices) runs.push_back(rows[i].run);
  return runs;
}

}  // namespace

TEST_CASE("the front holds the sound runs that no other beats, by cost") {
  const std::vector<Row> rows = study();
  CHECK(numbers(rows, pareto_front(rows, kErrors[0], kCosts[0])) == std::vector<int>{1, 4, 5});
  CHECK(numbers(rows, pareto_front(rows, kErrors[0], kCosts[1])) == std::vector<int>{5});
  CHECK(pareto_front({}, kErrors[0], kCosts[0]).empty());
  CHECK(pareto_front({planted_crash(1, 1)}, kErrors[0], kCosts[0]).empty());
  const std::vector<Row> equal = {planted(1, 1, 0.5), planted(2, 1, 0.5), planted(3, 2, 0.5)};
  CHECK(numbers(equal, pareto_front(equal, kErrors[0], kCosts[0])) == std::vector<int>{1});
}

TEST_CASE("a table is read back as it was written, commas, quotes and missing figures included") {
  const Folder folder;
  const std::vector<Row> rows = study();
  const std::vector<Row> back = read_csv(folder.write("trade.csv", to_csv(rows)));
  REQUIRE(back.size() == rows.size());
  CHECK(to_csv(back) == to_csv(rows));
  CHECK(back[6].failure == rows[6].failure);
  CHECK(back[6].settings == rows[6].settings);
  CHECK(back[4].figures.mean_forth == 0.1);
  CHECK(std::isnan(back[7].figures.mean_forth));
  CHECK(back[7].failed());
}

TEST_CASE("a table that is not ours is refused with its line") {
  const Folder folder;
  CHECK_THROWS_WITH(read_csv(folder.write("a.csv", "x,y\n1,2\n")), Contains("a.csv:1"));
  const std::string csv = to_csv(study());
  CHECK_THROWS_WITH(read_csv(folder.write("b.csv", csv + "1,2,3\n")),
                    Contains("b.csv:10: 3 cells"));
  CHECK(read_csv(folder.write("c.csv", "")).empty());
}

TEST_CASE("the recommendation names the best, the cheaper that is as good, and what fails") {
  const std::vector<Row> rows = study();
  CHECK(least_error(rows)->run == 5);
  CHECK(as_good_for_less(rows, rows[2])->run == 4);
  std::vector<Row> crossed = rows;
  crossed[3].figures.intersecting_pairs = 1;  // as near and cheaper, but it passes through itself
  CHECK(as_good_for_less(crossed, crossed[2])->run == 3);
  CHECK(as_good_for_less(rows, rows[0])->run == 1);
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
  rows[0].figures.topology_right = 0;
  CHECK(least_error(rows) == nullptr);
  CHECK_THAT(recommendation(rows, {"A scene", "a file"}), Contains("Nothing can be recommended"));
}

TEST_CASE("a plot's script marks failures, wrong topology and the front") {
  const std::string script = plot_script(study(), {"It's a scene", 0.1, "a \"file\""});
  CHECK_THAT(script, Contains("'It''s a scene'") && Contains("failed: surgeries were refused"));
  CHECK_THAT(script, Contains("\n5 9 8\nEOD"));  // the lost run at the height of the worst error
}
