// The scenes of the paper's fluid figures, coarse and short: papers/fluid/run makes them whole.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/paths.h"
#include "tests/sims/cli/program.h"

using nlohmann::json;
using namespace suture;

namespace {

json run(const std::string& figure, const std::string& changes) {
  const Folder folder;
  std::string words;
  std::istringstream settings(changes + " pictures.every=0 meshes.every=0");
  for (std::string setting; settings >> setting;) words += " --set " + setting;
  const Said said = suture_program("run " + source_dir() + "/papers/fluid/scenes/" + figure +
                                   ".toml -o " + folder.name("out") + words);
  INFO(said.text);
  REQUIRE(said.exit == 0);
  std::ifstream file(folder / "out/report.json");
  json report = json::parse(file);
  CHECK(report["summary"]["finished"] == true);
  CHECK(report["summary"]["refused"] == 0);  // a surgery whose audit fails is refused
  CHECK(report["audit"]["closed_manifold"] == true);
  return report;
}

double left(const json& report) {
  const json &first = report["steps"].front(), &last = report["steps"].back();
  return last["volume"].get<double>() / first["volume"].get<double>();
}

}  // namespace

// Bounds on volumes are measured, with some room: bodies of few cells lose more than whole figures.

TEST_CASE("Figure 7, coarse: a dam breaks and its wave folds", "[slow]") {
  const json report = run("figure_7",
                          "fluid.cell_size=0.0625 tracker.cell_size=0.0625 "
                          "quality.edge_length=0.06 bodies.parameters.edge_length=0.06 time.end=1");
  CHECK(std::abs(left(report) - 1) < 0.1);
  CHECK(report["summary"]["committed"] > 0);
}

TEST_CASE("Figure 1, coarse: carved balls fall onto one another and merge", "[slow]") {
  const json report =
      run("figure_1",
          "fluid.cell_size=0.1 tracker.cell_size=0.05 quality.edge_length=0.035 "
          "bodies.parameters.edge_length=0.035 fluid.viscoelasticity.modulus=10000 time.end=1.1");
  CHECK(report["summary"]["merges"] > 3);
  const double untouched = report["steps"].back()["untouched_area"];
  CHECK(untouched > 0.5);  // where nothing merged the carving stays
  CHECK(untouched < 1);
}

TEST_CASE("Figure 8, coarse: animals pile up, and have their legs", "[slow]") {
  const json report = run("figure_8",
                          "fluid.cell_size=0.08 tracker.cell_size=0.04 quality.edge_length=0.03 "
                          "bodies.parameters.edge_length=0.015 time.end=0.9");
  // At this size a leg's tip comes off and vanishes, which is no merge.
  CHECK(report["summary"]["committed"] > 0);
  CHECK(report["summary"]["vanished_bodies"].get<std::size_t>() <=
        report["summary"]["splits"].get<std::size_t>());
  CHECK(report["steps"].back()["untouched_area"] > 0.8);
  CHECK(std::abs(left(report) - 1) < 0.05);
}

TEST_CASE("Figure 10, coarse: hands under tension become drops, and stay two without topology",
          "[slow]") {
  const std::string coarse =
      "fluid.cell_size=0.05 tracker.cell_size=0.04 quality.edge_length=0.04 "
      "bodies.parameters.edge_length=0.0108 time.end=0.25";
  const json report = run("figure_10", coarse);
  CHECK(report["summary"]["splits"] > 0);
  CHECK(std::abs(left(report) - 1) < 0.05);
  const json apart = run("figure_10", coarse + " method.kind=mesh_without_topology");
  CHECK(apart["summary"]["remodels"] == 0);
  CHECK(apart["steps"].back()["components"] == 2);
}
