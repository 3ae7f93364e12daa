// The table of a trade study.
#include "sims/study/table/trade_row.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/errors.h"
#include "tests/sims/cli/program.h"
#include "tests/sims/study/trade_rows.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

TEST_CASE("a table is read back as it was written, commas, quotes and missing figures included") {
  const Folder folder;
  const std::vector<Row> rows = planted_study();
  const std::vector<Row> back = read_trade_table(folder.write("trade.csv", to_csv(rows)));
  REQUIRE(back.size() == rows.size());
  CHECK(to_csv(back) == to_csv(rows));
  CHECK(back[6].text("failure") == rows[6].text("failure"));
  CHECK(setting_texts(back[6]) == setting_texts(rows[6]));
  CHECK(back[4].number("mean_distance_forth") == 0.1);
  CHECK(std::isnan(back[7].number("mean_distance_forth")));
  CHECK(failed(back[7]));
}

TEST_CASE("a table that is not ours is refused with its line") {
  const Folder folder;
  CHECK_THROWS_WITH(read_trade_table(folder.write("a.csv", "x,y\n1,2\n")), Contains("a.csv:1"));
  const std::string csv = to_csv(planted_study());
  CHECK_THROWS_WITH(read_trade_table(folder.write("b.csv", csv + "1,2,3\n")),
                    Contains("b.csv:10: 3 cells"));
  CHECK(read_trade_table(folder.write("c.csv", "")).empty());
}

TEST_CASE("the columns of a trade study's table are those that were published") {
  const std::string csv = to_csv({trade_row({{"cell_size", "1"}, {"step", "2"}})});
  CHECK(csv.substr(0, csv.find('\n')) ==
        "run,design,change,cell_size,step,outcome,failure,mean_distance_forth,mean_distance_back,"
        "max_distance_forth,max_distance_back,volume_error,volume_drift,components,euler,"
        "topology_right,self_intersecting_pairs,triangles_without_area,least_angle,tracker_seconds,"
        "remodel_seconds,improve_seconds,move_seconds,total_seconds,seconds_spread,peak_megabytes,"
        "triangles_mean,triangles_max,triangles_end,steps,remodels,surgeries,refused,surface,"
        "repeats,study");
}
