// suture measure, as a user runs it, and the measures themselves where the answer is known.
#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/study/compare.h"
#include "sims/study/scene_run.h"
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

Said measured(const Folder& folder, const std::string& more) {
  return suture_program("measure " + folder.name("scene.toml") + " --csv " +
                        folder.name("rows.csv") + " " + more);
}

double number(const Record& record, const std::string& column) {
  INFO(column);
  const std::string text = text_in(record, column);
  REQUIRE_FALSE(text.empty());
  return std::strtod(text.c_str(), nullptr);
}

Truth truth_of(const Triangles& surface) {
  Truth truth;
  truth.exact.surface = surface;
  truth.volume = volume(surface);
  return truth;
}

}  // namespace

TEST_CASE("a shell round a ball is measured by its thickness and its volume") {
  const Triangles ball = sphere({.frequency = 16});
  const Record r = compare(scaled(ball, 1.01), truth_of(ball), {.samples = 5000, .lines = 60});
  CHECK(number(r, "mean_distance") == Approx(0.01).epsilon(0.01));
  CHECK(number(r, "max_distance") == Approx(0.01).epsilon(0.01));
  CHECK(number(r, "volume_error") == Approx(std::pow(1.01, 3) - 1));
  CHECK(number(r, "symmetric_difference") == Approx(std::pow(1.01, 3) - 1).epsilon(0.02));
  CHECK(text_in(r, "crease_mean").empty());
}

TEST_CASE("a box that was moved is as far away as it was moved, and creases tell by how much") {
  const Triangles a = box({.edge_length = 0.5});
  Truth truth = truth_of(a);
  for (std::uint32_t v = 0; v < a.positions.size(); ++v)
    if (a.positions[v].cwiseAbs().minCoeff() == 0.5) truth.exact.corners.push_back(v);
  REQUIRE(truth.exact.corners.size() == 8);
  const Record r = compare(translated(a, {0.02, 0, 0}), truth, {.samples = 5000, .lines = 60});
  CHECK(number(r, "volume_error") == Approx(0).margin(1e-12));
  CHECK(number(r, "symmetric_difference") == Approx(0.04).epsilon(0.05));
  CHECK(number(r, "max_distance") == Approx(0.02));
  // Four corners stick out by 0.02; the other four are on the moved box's sides.
  CHECK(number(r, "corner_max") == Approx(0.02));
  CHECK(number(r, "corner_mean") == Approx(0.01));
}

TEST_CASE("a corner that was rounded off is told from one that is there") {
  const Triangles a = zalesak({.centre = Point::Zero(), .edge_length = 1});
  Truth truth = truth_of(a);
  const double z = std::sqrt(15.0 * 15 - 10 * 10 - 2.5 * 2.5);
  for (std::uint32_t v = 0; v < a.positions.size(); ++v)
    if (a.positions[v][0] == 2.5 && a.positions[v][1] == 10 &&
        std::abs(a.positions[v][2]) > z - 1e-9)
      truth.exact.corners.push_back(v);
  REQUIRE(truth.exact.corners.size() == 2);
  const CompareOptions few{.samples = 1000, .lines = 20};
  CHECK(number(compare(a, truth, few), "corner_max") == 0);
  Triangles rounded = a;
  for (const std::uint32_t v : truth.exact.corners) rounded.positions[v] += Point(-0.5, -0.5, 0);
  CHECK(number(compare(rounded, truth, few), "corner_max") > 0.2);
}

TEST_CASE("markers are measured only where vertices still are markers") {
  const Triangles a = sphere({.frequency = 3});
  const Carry moved = [](const Point& p) -> Point { return p + Point(0.1, 0, 0); };
  const Record r = compare_markers(translated(a, {0.1, 0, 0.003}), a, moved);
  CHECK(number(r, "marker_max") == Approx(0.003));
  CHECK(number(r, "marker_mean") == Approx(0.003));
  CHECK(text_in(compare_markers(sphere({.frequency = 4}), a, moved), "marker_max").empty());
}

TEST_CASE("records keep their columns, replace their own and read back what they wrote") {
  const Folder folder;
  const auto file = folder / "t.csv";
  append_records(file, {{{"a", "1"}, {"key", "x, \"y\""}}}, "key");
  append_records(file, {{{"a", "2"}, {"b", "new"}, {"key", "z"}}}, "key");
  append_records(file, {{{"a", "3"}, {"key", "x, \"y\""}}}, "key");
  CHECK(contents(file) == "a,b,key\n2,new,z\n3,,\"x, \"\"y\"\"\"\n");
  CHECK(read_records(file).size() == 2);
  folder.write("bad.csv", "a,b\n1\n");
  CHECK_THROWS_AS(read_records(folder / "bad.csv"), InvalidInput);
}

TEST_CASE("every method's run of a turning ball is a row a time, with all that was measured") {
  const Folder folder;
  folder.write("scene.toml", kTurning);
  for (const char* method : {"markers", "mesh", "level_set"}) {
    const Said said = measured(folder, std::string("--samples 2000 --lines 30 --references ") +
                                           folder.name("refs") + " --method " + method);
    INFO(said.text);
    REQUIRE(said.exit == 0);
  }
  const std::vector<Record> rows = read_records(folder / "rows.csv");
  REQUIRE(rows.size() == 6);
  for (const Record& row : rows) {
    INFO(text_in(row, "method") << " at " << text_in(row, "time"));
    for (const char* column : {"seconds", "peak_megabytes", "triangles", "triangles_mean", "steps"})
      CHECK(number(row, column) > 0);
    CHECK(text_in(row, "outcome") == "done");
    CHECK(number(row, "components") == 1);
    CHECK(number(row, "euler") == number(row, "euler_expected"));
    CHECK(text_in(row, "closed_manifold") == "yes");
    CHECK(number(row, "resolution") == 20);
    const bool grid = text_in(row, "method") == "level_set";     // whose radius is 2.5 cells here
    CHECK(number(row, "mean_distance") < (grid ? 0.1 : 0.008));  // measured: 0.08, 0.003
    CHECK(number(row, "symmetric_difference") < (grid ? 0.5 : 0.05));  // measured: 0.41, 0.02
    CHECK_THAT(text_in(row, "command"), Contains("--method " + text_in(row, "method")));
    if (text_in(row, "method") == "markers") {
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
  CHECK(read_records(folder / "rows.csv").size() == 1);
  CHECK(measured(folder, few + " --set tracker.cell_size=0.3").exit == 0);
  CHECK(read_records(folder / "rows.csv").size() == 2);
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
    return number(read_records(folder / "rows.csv").at(0), "mean_distance");
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
  const std::vector<Record> rows = read_records(folder / "rows.csv");
  REQUIRE(rows.size() == 1);
  CHECK(text_in(rows[0], "outcome") == "timed_out");
  CHECK_THAT(text_in(rows[0], "failure"), Contains("out of time"));
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

TEST_CASE("a run ends where the surface is as few components as was asked for") {
  Scene scene = parse_scene(
      "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 5, radius = 0.3 }\ncopies = 4\n"
      "scatter_high = [1, 0.4, 0.4]\n[motion]\nkind = \"normal_flow\"\n[tracker]\ncell_size = 0.1\n"
      "[time]\nstep = 0.05\nend = 2\n[measure]\nuntil_components = 1\nreference = \"none\"\n",
      "scene.toml");
  const MethodRun run = run_method(scene, {2});
  REQUIRE(run.snapshots.size() == 1);
  CHECK(run.outcome == "done");
  CHECK(run.snapshots[0].time < 1);
  CHECK(components(run.snapshots[0].surface).count == 1);
}

TEST_CASE("a mesh that vanishes is measured as nothing at every time that was left") {
  Scene scene = parse_scene(
      "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 5, radius = 0.3 }\n"
      "[motion]\nkind = \"normal_flow\"\nspeed = -1\n[tracker]\ncell_size = 0.1\n"
      "[time]\nstep = 0.05\nend = 2\n[measure]\nreference = \"none\"\n",
      "scene.toml");
  const MethodRun run = run_method(scene, {0, 1, 2});
  REQUIRE(run.snapshots.size() == 3);
  CHECK_THAT(run.failure, Contains("nothing was left"));
  CHECK_FALSE(run.snapshots[0].surface.triangles.empty());
  for (const int i : {1, 2}) {
    CHECK(run.snapshots[i].surface.triangles.empty());
    CHECK(run.snapshots[i].time == i);
  }
}
