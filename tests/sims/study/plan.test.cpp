// A study's factors and its plan.
#include <catch2/catch.hpp>
#include <set>

#include "kernel/errors.h"
#include "kernel/formats/mesh_io.h"
#include "kernel/measure/measures.h"
#include "sims/study/plan.h"
#include "sims/study/reference.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

namespace {

const char* const kScene =
    "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 3 }\n"
    "[tracker]\ncell_size = 0.4\n[motion]\nkind = \"rotation\"\nrate = 1\n"
    "[time]\nstep = 0.1\nend = 1\nremodel_every = 2\nimprove_every = 5\n";

Settings own() {
  const Folder folder;
  return settings_of(read_scene(folder.write("scene.toml", kScene)));
}

std::vector<std::string> words(const std::vector<PlannedRun>& runs) {
  std::vector<std::string> all;
  for (const PlannedRun& run : runs) all.push_back(words_of(own(), run.changes));
  return all;
}

std::vector<PlannedRun> grid(const std::vector<std::string>& factors) {
  return plan(own(), designs_of(factors, own(), {.one = false, .grid = true}));
}

}  // namespace

TEST_CASE("values with an x are multiples of the scene's own, others stand as they are") {
  CHECK(words(grid({"cell_size=x0.5,0.3"})) ==
        std::vector<std::string>{"", "cell_size=0.2", "cell_size=0.3"});
  CHECK(words(grid({"remodel_every=x3,1"})) ==
        std::vector<std::string>{"", "remodel_every=6", "remodel_every=1"});
  CHECK(words(grid({"quality.keep_features=false"})) ==
        std::vector<std::string>{"", "keep_features=false"});
}

TEST_CASE("resolution multiplies cells and edges, after what else sets them") {
  CHECK(words(grid({"resolution=x2"})) ==
        std::vector<std::string>{"", "cell_size=0.8 edge_length=0.8"});
  CHECK(words(grid({"resolution=x2", "cell_size=0.1"})) ==
        std::vector<std::string>{"", "cell_size=0.2 edge_length=0.8"});
}

TEST_CASE("another time step keeps the time between remodels, unless that is varied too") {
  CHECK(words(grid({"step=x0.5,x4"})) ==
        std::vector<std::string>{"", "improve_every=10 remodel_every=4 step=0.05",
                                 "improve_every=1 remodel_every=1 step=0.4"});
  CHECK(words(grid({"step=x0.5", "remodel_every=x1,3"})) ==
        std::vector<std::string>{"", "improve_every=10 step=0.05",
                                 "improve_every=10 remodel_every=3 step=0.05"});
}

TEST_CASE("a grid is the product of its factors, and no run is planned twice") {
  const auto runs = grid({"collapse=straighten,keep", "cell_size=x1,x2,x3", "passes=3,1"});
  const auto all = words(runs);
  CHECK(runs.size() == 2 * 3 * 2);
  CHECK(std::set<std::string>(all.begin(), all.end()).size() == all.size());
  CHECK(runs.front().design == "own");
  const auto one = plan(own(), designs_of({"collapse=straighten,keep", "passes=3,1"}, own(),
                                          {.one = true, .grid = false}));
  REQUIRE(one.size() == 3);
  CHECK(one[1].design == "collapse");
  CHECK(one[2].design == "passes");
}

TEST_CASE("the default plan varies every choice that the issue asks for") {
  std::set<std::string> designs;
  std::string all;
  for (const PlannedRun& run : plan(own(), default_designs(own(), {}))) {
    designs.insert(run.design);
    all += words_of(own(), run.changes) + "\n";
  }
  for (const char* name : {"own", "grid", "arithmetic", "collapse", "placement", "cell_size",
                           "step", "remodel_every", "edge_length", "improve_every", "volume_bound"})
    CHECK(designs.count(name) == 1);
  CHECK_THAT(all, Contains("arithmetic=rational\n") && Contains("arithmetic=rounded\n") &&
                      Contains("arithmetic=rounded jitter=0\n") && Contains("improve_every=0"));
}

TEST_CASE("bad factors are refused with what is wrong and what is known") {
  const auto refused = [](const std::string& text, const std::string& says) {
    INFO(text);
    CHECK_THROWS_WITH(read_factor(text, own()), Contains(says));
    CHECK_THROWS_AS(read_factor(text, own()), InvalidInput);
  };
  refused("cel_size=1", "did you mean \"cell_size\"");
  refused("cell_size", "write name=value");
  refused("cell_size=", "write name=value");
  refused("=1", "write name=value");
  refused("cell_size=1,,2", "between two commas");
  refused("collapse=x2", "no number");
  refused("resolution=keep", "multiples above 0");
  refused("resolution=x0", "multiples above 0");
  refused("end=2", "cannot be varied");
  refused("origin=0", "cannot be varied");
  CHECK_THROWS_WITH(grid({"passes=1", "quality.passes=2"}), Contains("given twice"));
  std::string many = "cell_size=1";
  for (int i = 2; i < 200; ++i) many += "," + std::to_string(i);
  std::string more = "edge_length" + many.substr(many.find('='));
  CHECK_THROWS_WITH(grid({many, more}), Contains("more than 10000 runs"));
}

TEST_CASE("a motion that brings everything back is told from one that does not") {
  const Folder folder;
  const auto turned = [&](const std::string& rate) {
    std::string scene = kScene;
    scene.replace(scene.find("rate = 1"), 8, "rate = " + rate);
    return comes_back(folder.write("scene.toml", scene));
  };
  CHECK(turned("6.283185307179586"));
  CHECK_FALSE(turned("6.2"));
  CHECK(turned("0"));
}

TEST_CASE("the flow's reference is the first surface, carried as a field carries points") {
  const Folder folder;
  std::string scene = kScene;
  scene.replace(scene.find("rate = 1"), 8, "rate = 1.5707963267948966");  // a quarter turn about z
  const Reference r = make_reference({folder.write("scene.toml", scene), folder / "", {}},
                                     {.kind = "flow", .limit = {}});
  const Triangles turned = read_triangles(r.mesh),
                  start = read_scene(folder / "scene.toml").surface;
  CHECK(turned.triangles.size() > 25000);
  CHECK(turned.triangles.size() < 100000);
  CHECK(volume(turned) == Approx(volume(start)));
  for (std::size_t v = 0; v < start.positions.size(); ++v) {
    const Point& p = start.positions[v];
    CHECK((turned.positions[v] - Point(-p[1], p[0], p[2])).norm() < 1e-5);
  }
  scene.replace(scene.find("rotation"), 8, "normal_flow");
  scene.replace(scene.find("rate = "), 25, "");
  folder.write("scene.toml", scene);
  CHECK_THROWS_WITH(
      make_reference({folder / "scene.toml", folder / "", {}}, {.kind = "flow", .limit = {}}),
      Contains("depends on the surface"));
}

TEST_CASE("the finer run is finer in space and time than every run of the plan") {
  const Settings mine = own();
  const auto runs = grid({"resolution=x0.5,x2", "step=x0.5,x2", "arithmetic=rational"});
  const Settings finest = changed(mine, finest_changes(mine, runs, 0.7));
  const auto text = [&](const char* key) { return text_of(setting(finest, key).value); };
  CHECK(text("cell_size") == "0.14");
  CHECK(text("edge_length") == "0.14");
  CHECK(text("step") == "0.035");
  CHECK(text("remodel_every") == "6");
  CHECK(text("improve_every") == "14");
  CHECK(text("arithmetic") == "filtered");
}
