#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/execute.h"
#include "tests/sims/cli/program.h"

using namespace suture;
using namespace suture::sims;

namespace {

nlohmann::json json_of(const std::filesystem::path& file) {
  return nlohmann::json::parse(contents(file));
}

/// A seed whose case takes longer than any of the limits below: large, and run to its end.
std::string slow_seed() {
  for (std::uint64_t seed = 1;; ++seed) {
    const FuzzCase c = make_case(seed, {});
    if (c.surface.triangles.size() < 1000) continue;
    if (run_case(c, CheckChoice("fast")).counts.remodels >= 3) return std::to_string(seed);
  }
}

}  // namespace

TEST_CASE("fuzz runs a campaign and writes a summary that does not depend on the jobs") {
  const Folder folder;
  const Said one = suture_program("fuzz --cases 120 --seed 50 --summary " + folder.name("a.json"));
  const Said two =
      suture_program("fuzz --cases 120 --seed 50 --jobs 2 --summary " + folder.name("b.json"));
  CHECK(one.exit == 0);
  CHECK(two.exit == 0);
  const auto a = json_of(folder / "a.json"), b = json_of(folder / "b.json");
  CHECK(a["digest"] == b["digest"]);
  CHECK(a["oracles"] == b["oracles"]);
  CHECK(a["cases"] == 120);
  CHECK(a["surgeries"] > 50);
  CHECK(a["seeds"] == nlohmann::json::parse(R"([{"first": 50, "cases": 120}])"));
  CHECK(one.text.find("120 cases") != std::string::npos);
}

TEST_CASE("fuzz merges summaries of disjoint seeds and refuses to count a seed twice") {
  const Folder folder;
  const auto run = [&](const std::string& seed, const std::string& file) {
    suture_program("fuzz --cases 20 --oracles fast --seed " + seed + " --summary " +
                   folder.name(file));
  };
  run("1", "a.json");
  run("21", "b.json");
  run("30", "c.json");
  const std::string sum = folder.name("sum.json");
  CHECK(suture_program("fuzz --merge " + folder.name("a.json") + " " + folder.name("b.json") +
                       " -o " + sum)
            .exit == 0);
  CHECK(json_of(sum)["cases"] == 40);
  CHECK(json_of(sum)["seeds"].size() == 1);
  const Said overlap = suture_program("fuzz --merge " + folder.name("b.json") + " " +
                                      folder.name("c.json") + " -o " + sum);
  CHECK(overlap.exit == 2);
  CHECK(overlap.text.find("share seeds") != std::string::npos);
  CHECK(suture_program("fuzz --merge " + folder.name("a.json")).exit == 2);
  folder.write("d.json", "{}");
  CHECK(suture_program("fuzz --merge " + folder.name("d.json") + " -o " + sum).exit == 2);
}

TEST_CASE("fuzz shows a seed's case, which replays") {
  const Folder folder;
  const Said shown = suture_program("fuzz --show 12");
  CHECK(shown.exit == 0);
  CHECK(suture_program("fuzz --show 12 -o " + folder.name("case.toml")).exit == 0);
  CHECK(contents(folder / "case.toml") == shown.text);
  const Said replayed = suture_program("fuzz --replay " + folder.name("case.toml"));
  CHECK(replayed.exit == 0);
  CHECK(replayed.text.find("passes") != std::string::npos);
}

TEST_CASE("fuzz says which check a replayed case fails, and why, with exit code 1") {
  const Folder folder;
  suture_program("fuzz --show " + slow_seed() + " -o " + folder.name("case.toml"));
  const Said said = suture_program("fuzz --case-seconds 1e-9 --replay " + folder.name("case.toml"));
  CHECK(said.exit == 1);
  CHECK(said.text.find("hang: took more than") != std::string::npos);
}

TEST_CASE("a campaign with a failing case ends with exit code 1 and saves it") {
  const Folder folder;
  const Said said =
      suture_program("fuzz --cases 1 --seed " + slow_seed() +
                     " --oracles all --case-seconds 1e-9 --minimise-seconds 0.1 --corpus " +
                     folder.name("found") + " --summary " + folder.name("s.json"));
  CHECK(said.exit == 1);
  const auto s = json_of(folder / "s.json");
  REQUIRE(s["hangs"] > 0);
  CHECK(std::filesystem::exists(s["failures"][0]["file"].get<std::string>()));
}

TEST_CASE("refusals of rounded arithmetic are counted and are no failures") {
  const Folder folder;
  const Said said = suture_program(
      "fuzz --cases 150 --profile hostile --arithmetic rounded --jitter 0 "
      "--oracles audit,bits --summary " +
      folder.name("s.json"));
  CHECK(said.exit == 0);
  const auto s = json_of(folder / "s.json");
  CHECK_FALSE(s["refused"].empty());
  CHECK(s["arithmetic"] == "rounded");
  CHECK(s["oracles"].size() == 2);
}

TEST_CASE("fuzz refuses what it cannot do with exit code 2") {
  for (const char* bad : {"fuzz", "fuzz --cases 1 --oracles tarot", "fuzz --cases 1 --jobs 0",
                          "fuzz --cases 1 --profile kind", "fuzz --replay nowhere.toml",
                          "fuzz --cases 1 --summary nowhere/at/all.json"}) {
    CAPTURE(bad);
    CHECK(suture_program(bad).exit == 2);
  }
}
