// suture measure, as a user runs it.
#include <catch2/catch.hpp>
#include <cmath>

#include "sims/study/table/table.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

namespace {

const char* const kTurning =
    "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 8, radius = 0.5, x = 1 }\n"
    "[motion]\nkind = \"rotation\"\nrate = 6.283185307179586\n"
    "[tracker]\ncell_size = 0.2\n[quality]\nedge_length = 0.12\n"
    "[time]\nstep = 0.05\nend = 1\n[measure]\nat = [0.5, 1]\ndomain = 4\ntolerance = 0.01\n";

/// The columns as they were published.
const char* const kColumns =
    "run,scene,method,resolution,cell_size,edge_length,time_step,topology_interval,"
    "improve_interval,start_triangles,changes,command,time,outcome,failure,steps,seconds,"
    "seconds_per_million_triangle_steps,seconds_by_part,peak_megabytes,triangles,triangles_mean,"
    "triangles_max,cells_resampled,surgeries,refused,counts,components,components_expected,euler,"
    "euler_expected,closed_manifold,self_intersecting_pairs,triangles_without_area,least_angle,"
    "volume,volume_drift,reference,volume_error,symmetric_difference,symmetric_difference_error,"
    "line_spacing,mean_distance,max_distance,mean_distance_forth,mean_distance_back,"
    "max_distance_forth,max_distance_back,sample_spacing,crease_mean,crease_max,corner_mean,"
    "corner_max,reference_tolerance,reference_mean_error,reference_max_error,marker_mean,marker_"
    "max,"
    "fingerprint";

Said measured(const Folder& folder, const std::string& more) {
  return suture_program("measure " + folder.name("scene.toml") + " --csv " +
                        folder.name("rows.csv") + " " + more);
}

double number(const Row& record, const std::string& column) {
  INFO(column);
  REQUIRE_FALSE(record.text(column).empty());
  return record.number(column);
}

}  // namespace

TEST_CASE("every method's run of a turning ball is a row a time, with all that was measured") {
  const Folder folder;
  folder.write("scene.toml", kTurning);
  for (const char* method : {"markers", "mesh", "level_set"}) {
    const Said said = measured(folder, std::string("--samples 2000 --lines 30 --references ") +
                                           folder.name("refs") + " --method " + method);
    INFO(said.text);
    REQUIRE(said.exit == 0);
  }
  const std::vector<Row> rows = read_table(folder / "rows.csv").rows;
  REQUIRE(rows.size() == 6);
  const std::string csv = contents(folder / "rows.csv");
  CHECK(csv.substr(0, csv.find('\n')) == kColumns);
  for (const Row& row : rows) {
    INFO(row.text("method") << " at " << row.text("time"));
    for (const char* column : {"seconds", "peak_megabytes", "triangles", "triangles_mean", "steps"})
      CHECK(number(row, column) > 0);
    CHECK(row.text("outcome") == "done");
    CHECK(number(row, "components") == 1);
    CHECK(number(row, "euler") == number(row, "euler_expected"));
    CHECK(row.text("closed_manifold") == "yes");
    CHECK(number(row, "resolution") == 20);
    const bool grid = row.text("method") == "level_set";         // whose radius is 2.5 cells here
    CHECK(number(row, "mean_distance") < (grid ? 0.1 : 0.008));  // measured: 0.08, 0.003
    CHECK(number(row, "symmetric_difference") < (grid ? 0.5 : 0.05));  // measured: 0.41, 0.02
    CHECK_THAT(row.text("command"), Contains("--method " + row.text("method")));
    if (row.text("method") == "markers") {
      CHECK(number(row, "marker_max") < 1e-3);  // measured: 3e-4, RK4 in 20 steps
      CHECK(number(row, "volume_error") < 0);
    }
  }
}

TEST_CASE("rows that the table has are not made again, unless afresh") {
  const Folder folder;
  folder.write("scene.toml", kTurning);
  const std::string few = "--samples 500 --lines 10 --method markers --at 0.5 --reference none";
  REQUIRE(measured(folder, few).exit == 0);
  const std::string before = contents(folder / "rows.csv");
  CHECK_THAT(measured(folder, few).text, Contains("are there"));
  CHECK(contents(folder / "rows.csv") == before);
  CHECK(measured(folder, few + " --afresh").exit == 0);
  CHECK(read_table(folder / "rows.csv").rows.size() == 1);
  CHECK(measured(folder, few + " --set tracker.cell_size=0.3").exit == 0);
  CHECK(read_table(folder / "rows.csv").rows.size() == 2);
}

TEST_CASE("a reference that was damaged is made again") {
  const Folder folder;
  folder.write("scene.toml", kTurning);
  const std::string more =
      "--samples 500 --lines 10 --method markers --at 0.5 --afresh "
      "--references " +
      folder.name("refs");
  REQUIRE(measured(folder, more).exit == 0);
  const auto mean = [&] {
    return number(read_table(folder / "rows.csv").rows.at(0), "mean_distance");
  };
  const double right = mean();
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "refs"))
    files.push_back(entry.path());
  REQUIRE(files.size() == 2);
  for (const auto& file : files) {
    for (const char* damaged : {"", "[1]", "{}", "ply\n"}) {
      std::ofstream(file) << damaged;
      INFO(file << " as " << damaged);
      CHECK(measured(folder, more).exit == 0);
      CHECK(mean() == right);
      CHECK(contents(file).size() > 20);
    }
  }
}

TEST_CASE("a run that cannot go on is a row that says why") {
  const Folder folder;
  folder.write("scene.toml", kTurning);
  const Said said = measured(folder, "--set time.step=1e-4 --set time.end=1000 --limit-seconds 1");
  INFO(said.text);
  CHECK(said.exit == 1);
  const std::vector<Row> rows = read_table(folder / "rows.csv").rows;
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].text("outcome") == "timed_out");
  CHECK_THAT(rows[0].text("failure"), Contains("out of time"));
  const Said again = measured(folder, "--set time.step=1e-4 --set time.end=1000");
  CHECK_THAT(again.text, Contains("are there"));
  CHECK(again.exit == 1);  // a failure that is in the table is one still
}

TEST_CASE("measuring what is misspelt or impossible is refused before anything is run") {
  const Folder folder;
  folder.write("scene.toml", kTurning);
  for (const char* bad :
       {"--set cell_size=1", "--set tracker.cel_size=1", "--method grid",
        "--set tracker.cell_size=-1", "--samples 1", "--tolerance 0", "--tolerance 1e-300",
        "--set tracker.origin=[a,b,c]", "--at nan", "--at=-1", "--at 1.5", "--reference polyhedral",
        "--reference missing.ply", "--name a/b"}) {
    const Said said = measured(folder, bad);
    INFO(bad << ": " << said.text);
    CHECK(said.exit == 2);
    CHECK(folder.files() == 1);
  }
}

TEST_CASE("what depends on the surface has no exact answer, which is said before it is run") {
  const Folder folder;
  folder.write("scene.toml",
               "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 3 }\n"
               "[motion]\nkind = \"normal_flow\"\n[tracker]\ncell_size = 0.5\n"
               "[time]\nstep = 0.05\nend = 0.1\n");
  const Said said = measured(folder, "--samples 500");
  CHECK(said.exit == 2);
  CHECK_THAT(said.text, Contains("depends on the surface"));
  CHECK(measured(folder, "--samples 500 --reference none").exit == 0);
}
