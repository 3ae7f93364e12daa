#include "sims/scene/scene.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "sims/scene/toml_keys.h"
#include "surgery/model/option_table.h"
#include "tests/option_checks.h"
#include "tests/paths.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

namespace {

const char* const kBody = "[[bodies]]\nshape = \"sphere\"\nparameters = { frequency = 4 }\n";
const char* const kMotion = "[motion]\nkind = \"rest\"\n";
const char* const kTracker = "[tracker]\ncell_size = 0.3\n";
const char* const kTime = "[time]\nstep = 0.1\nend = 1\n";

std::string small_scene(const std::string& more = "") {
  return std::string(kBody) + kMotion + kTracker + kTime + more;
}

Scene scene_of(const std::string& text) {
  const Folder folder;
  return read_scene(folder.write("scene.toml", text));
}

/// The message with which a scene is refused.
std::string refusal(const std::string& text) {
  try {
    scene_of(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "not refused";
}

using Catch::Matchers::Contains;

}  // namespace

TEST_CASE("a small scene is read with its defaults") {
  const Scene scene = scene_of(small_scene());
  CHECK(scene.surface.triangles.size() == 20 * 16);
  CHECK(scene.phases.size() == 1);
  CHECK(scene.tracker.cell_size == 0.3);
  CHECK(scene.tracker.events == Events::both);
  CHECK(scene.tracker.quality.passes == QualityOptions{}.passes);
  CHECK(scene.time.steps() == 10);
  CHECK_FALSE(scene.output.pictures.any());
}

TEST_CASE("every option of the tracker and its quality can be set in a scene") {
  const auto check = [](const auto& table, const std::string& start, const auto& part) {
    for (const auto& row : table.rows()) {
      if (row.name == "cell_size") continue;  // is in each scene
      Value value = *row.about.usual;         // another one than that
      for (const Value& other : allowed_values(row.about))
        if (as_held(row.about, other) != *row.about.usual && in_words(other).size() < 20)
          value = other;
      INFO(row.name << " = " << in_words(value));
      REQUIRE(as_held(row.about, value) != *row.about.usual);
      const std::string still = "[time]\nstep = 0.1\nend = 1\nimprove_every = 0\n";
      const Scene scene = scene_of(std::string(kBody) + kMotion + still + start + row.name + " = " +
                                   toml_of(value) + "\n");
      CHECK(row.field.get(part(scene)) == as_held(row.about, value));
    }
  };
  check(tracker_options(), kTracker, [](const Scene& s) { return s.tracker; });
  check(quality_options(), std::string(kTracker) + "[quality]\n",
        [](const Scene& s) { return s.tracker.quality; });
}

TEST_CASE("an unknown key is refused with its line, its table and the nearest name") {
  const std::string text =
      refusal(std::string(kBody) + kMotion + kTime + "[tracker]\ncell_size = 0.3\ndeph = 2\n");
  CHECK_THAT(text, Contains("scene.toml:11") && Contains("tracker.deph") &&
                       Contains("did you mean \"depth\"?") && Contains("cell_test"));
}

TEST_CASE("an unknown table is refused with its line and the nearest name") {
  CHECK_THAT(refusal(small_scene("[trakcer]\n")),
             Contains("scene.toml:11") && Contains("did you mean [tracker]?"));
  CHECK_THAT(refusal("titel = \"x\"\n" + small_scene()),
             Contains("scene.toml:1") && Contains("did you mean \"title\"?"));
}

TEST_CASE("a value of the wrong type is refused, saying which type is wanted") {
  CHECK_THAT(
      refusal(std::string(kBody) + kMotion + kTracker + "[time]\nstep = \"small\"\nend = 1\n"),
      Contains("time.step") && Contains("is a text") && Contains("give a number"));
  CHECK_THAT(refusal(small_scene("remodel_every = 1.5\n")),
             Contains("time.remodel_every") && Contains("give an integer"));
  CHECK_THAT(refusal(small_scene("[pictures]\nedges = 1\n")), Contains("give true or false"));
  CHECK_THAT(refusal(small_scene("[pictures]\nup = [0, 1]\n")), Contains("give three"));
  CHECK_THAT(refusal(small_scene("[pictures]\nat = [0, \"end\"]\n")),
             Contains("scene.toml:12") && Contains("numbers only"));
  CHECK_THAT(refusal(small_scene("[pictures]\nat = 1979-05-27\n")), Contains("dates"));
}

TEST_CASE("a value out of range is refused, saying what is allowed") {
  const std::string start = std::string(kBody) + kMotion + kTime + "[tracker]\n";
  CHECK_THAT(refusal(start + "cell_size = 0\n"), Contains("allowed is above 0"));
  CHECK_THAT(refusal(start + "cell_size = -1\n"), Contains("is -1"));
  CHECK_THAT(refusal(start + "cell_size = nan\n"), Contains("give a finite number"));
  CHECK_THAT(refusal(start + "cell_size = inf\n"), Contains("give a finite number"));
  CHECK_THAT(refusal(start + "cell_size = 0.1\ndepth = -1\n"), Contains("from 0 to"));
  CHECK_THAT(refusal(start + "cell_size = 0.1\nevents = \"merges\"\n"),
             Contains("did you mean \"merge\"?") && Contains("merge, split, both, none"));
  CHECK_THAT(refusal(small_scene("[quality]\nshortest = 2\n")), Contains("from 0 to 1"));
  CHECK_THAT(refusal(std::string(kBody) + kMotion + kTracker + "[time]\nstep = 1e-12\nend = 1\n"),
             Contains("steps"));
}

TEST_CASE("what a scene lacks is named") {
  CHECK_THAT(refusal(std::string(kMotion) + kTracker + kTime), Contains("bodies: is missing"));
  CHECK_THAT(refusal(std::string(kBody) + kTracker + kTime), Contains("motion.kind"));
  CHECK_THAT(refusal(std::string(kBody) + kMotion + kTime), Contains("tracker.cell_size"));
  CHECK_THAT(refusal(std::string(kBody) + kMotion + kTracker), Contains("time.step"));
  CHECK_THAT(refusal(""), Contains("is missing"));
}

TEST_CASE("text that is not TOML is refused with its line") {
  CHECK_THAT(refusal("title = \"x\"\ncell_size = = 2\n"), Contains("scene.toml:2"));
  CHECK_THROWS_AS(read_scene("no/such/scene.toml"), InvalidInput);
}

TEST_CASE("a motion's unknown name and unknown parameter are refused") {
  const auto with_motion = [](const std::string& motion) {
    return std::string(kBody) + kTracker + kTime + "[motion]\n" + motion;
  };
  CHECK_THAT(refusal(with_motion("kind = \"enrigth\"\n")),
             Contains("did you mean \"enright\"?") && Contains("scene.toml:10"));
  CHECK_THAT(refusal(with_motion("kind = \"enright\"\nperiode = 2\n")),
             Contains("did you mean \"period\"?") && Contains("scene.toml:11"));
  CHECK_THAT(refusal(with_motion("kind = \"rotation\"\naxis = [0, 0, 0]\n")),
             Contains("no direction") && Contains("scene.toml:10"));
}

TEST_CASE("motions that take over from each other need times in order") {
  const auto two = [](const std::string& first, const std::string& second) {
    return std::string(kBody) + kTracker + kTime + "[[motion]]\nkind = \"rest\"\n" + first +
           "[[motion]]\nkind = \"normal_flow\"\n" + second;
  };
  CHECK(scene_of(two("until = 0.5\n", "")).phases.size() == 2);
  CHECK_THAT(refusal(two("", "")), Contains("until"));
  CHECK_THAT(refusal(two("until = 0.5\n", "until = 0.4\n")), Contains("above 0.5"));
}

TEST_CASE("a body is one of shape, mesh and model") {
  const auto with_body = [](const std::string& body) {
    return std::string(kMotion) + kTracker + kTime + "[[bodies]]\n" + body;
  };
  CHECK_THAT(refusal(with_body("scale = 2\n")), Contains("give one of shape, mesh"));
  CHECK_THAT(refusal(with_body("shape = \"sphere\"\nmesh = \"a.ply\"\n")), Contains("only one"));
  CHECK_THAT(refusal(with_body("shape = \"sfere\"\n")),
             Contains("scene.toml:9") && Contains("sphere"));
  CHECK_THAT(refusal(with_body("shape = \"sphere\"\nparameters = { radios = 1 }\n")),
             Contains("radios"));
  CHECK_THAT(refusal(with_body("shape = \"sphere\"\nscale = 0\n")), Contains("above 0"));
  CHECK_THAT(refusal(with_body("mesh = \"missing.ply\"\n")), Contains("missing.ply"));
  CHECK_THAT(refusal(with_body("model = \"no-such-model\"\n")), Contains("fallback"));
  const Scene scene = scene_of(with_body(
      "model = \"no-such-model\"\nfallback = \"sphere\"\nparameters = { frequency = 2 }\n"));
  CHECK(scene.surface.triangles.size() == 80);
  CHECK(scene.notes.size() == 1);
}

TEST_CASE("bodies are scaled, turned, moved and scattered") {
  const Scene scene = scene_of(
      std::string(kMotion) + kTracker + kTime +
      "[[bodies]]\nshape = \"box\"\nparameters = { edge_length = 1, size_x = 2 }\nscale = 2\n"
      "rotate = 90\ntranslate = [10, 0, 0]\ncopies = 3\nscatter_high = [0, 0, 50]\n");
  CHECK(components(scene.surface).count == 3);
  const Box box = bounding_box(scene.surface.positions);
  CHECK(box.low[0] == Approx(9));
  CHECK(box.high[1] == Approx(2));
  CHECK(volume(scene.surface) == Approx(3 * 16));
}

TEST_CASE("steps reach the end exactly once, whatever rounding does") {
  TimeOptions time;
  time.step = 0.1;
  time.end = 0.3;
  CHECK(time.steps() == 3);
  time.end = 0.31;
  CHECK(time.steps() == 4);
  time.end = 0;
  CHECK(time.steps() == 0);
}

TEST_CASE("pictures are wanted at the start, at the end, and where asked") {
  TimeOptions time;
  time.step = 0.1;
  time.end = 1;
  const Every some{4, {0.52}};
  std::vector<int> wanted;
  for (int i = 0; i <= 10; ++i)
    if (some.wants(i, time)) wanted.push_back(i);
  CHECK(wanted == std::vector<int>{0, 4, 5, 8, 10});
  CHECK_FALSE(Every{}.wants(0, time));
}

TEST_CASE("every scene that comes with Suture is read and starts as a closed manifold") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_dir() + "/data/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path().string());
    CHECK(audit(read_scene(entry.path()).surface).closed_manifold());
    ++count;
  }
  CHECK(count >= 11);
}

TEST_CASE("values that would need more triangles than can be held are refused with numbers") {
  const std::string fine = refusal(small_scene("[quality]\nedge_length = 1e-4\n"));
  CHECK_THAT(fine, Contains("quality.edge_length") && Contains("e+09") && Contains("50000000"));
  CHECK_THAT(refusal(std::string(kBody) + kMotion + kTime + "[tracker]\ncell_size = 1e-4\n"),
             Contains("tracker.cell_size") && Contains("50000000"));
  CHECK_THAT(refusal(small_scene("[quality]\nedge_length = 1e-320\n")), Contains("edge_length"));
  CHECK_THAT(refusal(std::string(kBody) + "copies = 1000000\n" + kMotion + kTracker + kTime),
             Contains("copies") && Contains("1000000") && Contains("320 triangles"));
  CHECK(refusal(small_scene("[quality]\nedge_length = 0.01\n")) == "not refused");
  const std::string still = "[time]\nstep = 0.1\nend = 1\nimprove_every = 0\n";
  CHECK(refusal(std::string(kBody) + kMotion + kTracker + still +
                "[quality]\nedge_length = 1e-4\n") == "not refused");
}

TEST_CASE("a body that scaling, turning, moving or scattering would lose is refused by its key") {
  const auto body = [](const std::string& how) {
    return refusal(kBody + how + "\n" + kMotion + kTracker + "[time]\nstep = 0.1\nend = 1\n" +
                   "improve_every = 0\n");
  };
  CHECK_THAT(body("scale = 1e308\ntranslate = [1e308, 0, 0]"), Contains("translate: "));
  CHECK_THAT(body("translate = [1.7976931348623157e308, 0, 0]\nscale = 1e300"),
             Contains("translate: ") && Contains("beyond what a double can hold"));
  CHECK_THAT(body("rotate = 1\nrotate_axis = [1.7e308, 1.7e308, 0]"), Contains("rotate_axis: "));
  CHECK_THAT(body("scatter_low = [-1e308, 0, 0]\nscatter_high = [1e308, 0, 0]"),
             Contains("scatter_high: is too far"));
  CHECK(body("rotate = 1e308") == "not refused");
}

TEST_CASE("names of many parts and tables nested deep are refused before they take the stack") {
  std::string name = "a";
  for (int i = 0; i < 100'000; ++i) name += ".a";
  CHECK_THAT(refusal("\n" + name + " = 1\n"), Contains("scene.toml:2: a name has more than 16"));
  CHECK_THAT(refusal("[" + name + "]\n"), Contains("scene.toml:1: a name has more than 16"));
  CHECK_THAT(refusal("x = \"\"\"a\"b\"\"\"\n" + name + " = 1\n"),
             Contains("scene.toml:2: a name has more than 16"));
  std::string nested = "1";
  for (int i = 0; i < 100; ++i) nested = "{ a.b = " + nested + " }";
  CHECK_THAT(refusal("x = " + nested + "\n"), Contains("nested more than 16 deep"));
  const std::string dots(200, '.');
  CHECK(refusal("title = \"" + dots + "\" # " + dots + "\n" + small_scene()) == "not refused");
}
