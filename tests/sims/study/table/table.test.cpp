// Rows, in memory, in CSV files and as bytes.
#include "sims/study/table/table.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/errors.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

TEST_CASE("records keep their columns, replace their own and read back what they wrote") {
  const Folder folder;
  const auto file = folder / "t.csv";
  append_rows(file, {{{"a", "1"}, {"key", "x, \"y\""}}}, "key");
  append_rows(file, {{{"a", "2"}, {"b", "new"}, {"key", "z"}}}, "key");
  append_rows(file, {{{"a", "3"}, {"key", "x, \"y\""}}}, "key");
  CHECK(contents(file) == "a,b,key\n2,new,z\n3,,\"x, \"\"y\"\"\"\n");
  CHECK(read_table(file).rows.size() == 2);
  folder.write("bad.csv", "a,b\n1\n");
  CHECK_THROWS_AS(read_table(folder / "bad.csv"), InvalidInput);
}

TEST_CASE("a cell is a text or a number of nine digits, and what is not known is empty") {
  Row row{{"name", "a ball"}, {"third", 1.0 / 3}, {"unknown", kUnknown}, {"count", 1234567.0}};
  CHECK(row.text("name") == "a ball");
  CHECK(row.text("third") == "0.333333333");
  CHECK(row.number("third") == 1.0 / 3);
  CHECK(row.text("unknown").empty());
  CHECK(row.text("count") == "1234567");
  CHECK(row.text("nothing").empty());
  CHECK_THROWS_AS(row.number("thrid"), InternalFailure);
  row.set("third", "2.5");
  CHECK(row.number("third") == 2.5);
  CHECK(row.cells().size() == 4);
  row.set("fourth", "");
  CHECK(std::isnan(row.number("fourth")));
}

TEST_CASE("rows go from process to process with all bits of their numbers") {
  const std::vector<Row> rows = {
      {{"a", 0.1}, {"b", kUnknown}, {"c", "x \"y\"\n"}}, {{"a", -1e-300}, {"d", INFINITY}}, {}};
  const std::vector<Row> back = unpacked(packed(rows));
  REQUIRE(back.size() == 3);
  CHECK(back[0].number("a") == 0.1);
  CHECK(std::isnan(back[0].number("b")));
  CHECK(back[0].text("c") == rows[0].text("c"));
  CHECK(back[1].number("a") == -1e-300);
  CHECK(back[1].text("d") == "inf");
  CHECK(back[2].cells().empty());
}
