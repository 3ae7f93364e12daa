// suture trade, as a user runs it.
#include <png.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "sims/study/report/plot.h"
#include "sims/study/table/trade_row.h"
#include "tests/paths.h"
#include "tests/sims/cli/program.h"
#include "tests/sims/study/trade_rows.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

namespace {

const char* const kMeeting =
    "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 6, radius = 0.5, x = -0.6 }\n"
    "velocity = [1, 0, 0]\n"
    "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 6, radius = 0.5, x = 0.6 }\n"
    "velocity = [-1, 0, 0]\n"
    "[motion]\nkind = \"bodies\"\n[tracker]\ncell_size = 0.12\norigin = [0.01, 0.02, 0.03]\n"
    "[time]\nstep = 0.05\nend = 0.3\n";

Said traded(const Folder& folder, const std::string& more) {
  return suture_program("trade " + folder.name("scene.toml") + " -o " + folder.name("out") + " " +
                        more);
}

std::vector<Row> table(const Folder& folder) { return read_trade_table(folder / "out/trade.csv"); }

/// Shares of a picture's pixels that are not white, and that are the front's red.
struct Ink {
  double dark = 0, red = 0;
};

Ink ink_of(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, file.c_str()) != 0);
  image.format = PNG_FORMAT_RGB;
  std::vector<unsigned char> bytes(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0);
  Ink ink;
  const double share = 3.0 / static_cast<double>(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    ink.dark += bytes[i] + bytes[i + 1] + bytes[i + 2] < 3 * 200 ? share : 0;
    ink.red += bytes[i] > 180 && bytes[i + 1] < 60 && bytes[i + 2] < 60 ? share : 0;
  }
  return ink;
}

}  // namespace

TEST_CASE("a study leaves a whole table, plots and a recommendation, and is resumed") {
  const Folder folder;
  folder.write("scene.toml", kMeeting);
  const std::string factors = "--factors collapse=straighten,keep step=x1,x2";
  const Said said = traded(folder, factors);
  INFO(said.text);
  REQUIRE(said.exit == 0);
  const std::vector<Row> rows = table(folder);
  REQUIRE(rows.size() == 4);
  for (const Row& row : rows) {
    CHECK(row.text("outcome") == "done");
    for (const char* figure : kFigures) {
      INFO(figure);
      if (std::string(figure) != "seconds_spread") CHECK_FALSE(std::isnan(row.number(figure)));
    }
    CHECK(row.number("components") == 1);
    CHECK(tracker_seconds(row) <= row.number("total_seconds"));
    CHECK(mean_distance(row) < 0.05);
  }
  for (const char* file :
       {"error_seconds.png", "error_memory.png", "recommendation.md", "trade.gp"})
    CHECK(std::filesystem::exists(folder / ("out/" + std::string(file))));
  CHECK_THAT(contents(folder / "out/recommendation.md"), Contains("## Choose"));

  const std::string before = contents(folder / "out/trade.csv");
  CHECK_THAT(traded(folder, factors).text, Contains("4 runs, 0 of them now"));
  CHECK(contents(folder / "out/trade.csv") == before);
  CHECK_THAT(traded(folder, "--factors collapse=straighten,keep passes=1").text,
             Contains("3 runs, 2 of them now"));
  CHECK(table(folder).size() == 6);
}

TEST_CASE("a table that lacks rows is completed, and one of another scene is refused") {
  const Folder folder;
  folder.write("scene.toml", kMeeting);
  const std::string more = "--reference start --factors passes=1,2,3";
  REQUIRE(traded(folder, more).exit == 0);
  std::vector<Row> rows = table(folder);
  rows.erase(rows.begin() + 1);
  folder.write("out/trade.csv", to_csv(rows));
  CHECK_THAT(traded(folder, more).text, Contains("3 runs, 1 of them now"));
  CHECK(table(folder).size() == 3);
  CHECK_THAT(traded(folder, more + " --repeat 2 --jobs 2").text, Contains("3 runs, 3 of them now"));
  CHECK(table(folder).size() == 3);
  CHECK(table(folder)[0].number("seconds_spread") >= 0);
  folder.write("scene.toml", kMeeting + std::string("[quality]\nedge_length = 0.11\n"));
  const Said other = traded(folder, more);
  CHECK(other.exit == 2);
  CHECK_THAT(other.text, Contains("of another scene"));
}

TEST_CASE("a run that cannot go on is a row that says so, and the others are made") {
  const Folder folder;
  folder.write("scene.toml", kMeeting + std::string("[quality]\nedge_length = 0.11\n"));
  const Said said =
      traded(folder, "--reference start --design one --factors passes=1 cell_size=1e-9");
  INFO(said.text);
  CHECK(said.exit == 0);
  std::size_t count = 0;
  for (const Row& row : table(folder)) {
    if (!failed(row)) continue;
    ++count;
    CHECK(row.text("change") == "cell_size=1e-09");
    CHECK(row.text("outcome") == "stopped");
    CHECK(row.text("failure").size() > 20);
  }
  CHECK(count == 1);
  CHECK(table(folder).size() == 3);
  CHECK_THAT(contents(folder / "out/recommendation.md"), Contains("`cell_size=1e-09`: stopped: "));
}

TEST_CASE("exact arithmetics give the same bits, and the reference's own settings no error") {
  const Folder folder;
  folder.write("scene.toml", kMeeting + std::string("[meshes]\nat = [0.3]\n"));
  REQUIRE(suture_program("run " + folder.name("scene.toml") + " -o " + folder.name("run")).exit ==
          0);
  const Said said =
      traded(folder, "--factors arithmetic=filtered,rational passes=1,3 --reference " +
                         folder.name("run/00006.ply"));
  INFO(said.text);
  REQUIRE(said.exit == 0);
  const std::vector<Row> rows = table(folder);
  REQUIRE(rows.size() == 4);
  for (const Row& a : rows)
    for (const Row& b : rows) {
      const auto passes = [](const Row& row) {
        return row.text("change").find("passes") == std::string::npos;
      };
      CHECK((a.text("surface") == b.text("surface")) == (passes(a) == passes(b)));
      if (passes(a)) CHECK(mean_distance(a) < 1e-12);
      if (!passes(a)) CHECK(mean_distance(a) > 1e-6);
    }
}

TEST_CASE("bad factors and options are refused before anything is run or written") {
  const Folder folder;
  folder.write("scene.toml", kMeeting);
  for (const char* bad :
       {"--factors cell_size=-1", "--factors collapse=none", "--factors cel_size=1",
        "--factors smallest_angle=x9", "--factors passes=0.5", "--factors", "--design all",
        "--jobs 0", "--repeat 0", "--limit-seconds 0", "--topology 1", "--factors passes=1,"}) {
    const Said said = traded(folder, bad);
    INFO(bad << ": " << said.text);
    CHECK(said.exit == 2);
    CHECK(said.text.size() > 10);
    CHECK(folder.files() == 1);
  }
  CHECK(suture_program("trade none.toml -o " + folder.name("out")).exit == 2);
  CHECK(traded(folder, "--reference none.ply").exit == 2);
}

TEST_CASE("where there is no gnuplot the table is kept and the user told what to install") {
  const Folder folder;
  folder.write("scene.toml", kMeeting);
  const std::string command = "PATH=/nowhere " + program_path() + " trade " +
                              folder.name("scene.toml") + " -o " + folder.name("bare") +
                              " --reference start --factors passes=1 2>" + folder.name("error");
  CHECK(WEXITSTATUS(std::system(command.c_str())) == 2);
  CHECK_THAT(contents(folder / "error"), Contains("apt-get install gnuplot-nox"));
  CHECK(read_trade_table(folder / "bare/trade.csv").size() == 2);
}

TEST_CASE("the plots of planted rows show the front and are not blank") {
  const Folder folder;
  std::vector<Row> rows = {planted(1, 1, 0.8), planted(2, 4, 0.4, "own"),
                           planted(3, 3, 0.3, "passes"), planted(4, 9, 0.1)};
  REQUIRE(draw(rows, {"A scene", 0.1, "a file"}, folder / "").empty());
  const Ink sound = ink_of(folder.name("error_seconds.png"));
  CHECK(sound.dark > 0.005);
  CHECK(sound.dark < 0.2);
  CHECK(sound.red > 0.0005);
  CHECK(ink_of(folder.name("error_memory.png")).dark > 0.005);
  CHECK(ink_of(folder.name("choices.png")).dark > 0.005);
  rows.push_back(planted_crash(5, 6));
  rows.push_back(planted_crash(6, 7));
  REQUIRE(draw(rows, {"A scene", 0.1, "a file"}, folder / "").empty());
  CHECK(ink_of(folder.name("error_seconds.png")).red > sound.red);
}
