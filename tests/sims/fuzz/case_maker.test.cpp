#include <catch2/catch.hpp>
#include <map>

#include "kernel/shapes/shapes.h"
#include "sims/fuzz/case_file.h"
#include "sims/fuzz/case_maker.h"

using namespace suture;
using namespace suture::sims;

namespace {

std::string text_of(const FuzzCase& c) { return to_toml({c, {}, {}}); }

Triangles a_ball(const GeneratorInput& in) {
  return sphere({Point::Zero(), in.draws.uniform("radius", 0.5, 1), 0.1, 2});
}

}  // namespace

TEST_CASE("a seed gives the same case again, and another seed another one") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string one = text_of(make_case(seed, {}));
    CHECK(one == text_of(make_case(seed, {})));
    CHECK(one != text_of(make_case(seed + 1000, {})));
  }
}

TEST_CASE("profiles, arithmetic, collapse and jitter are as asked for") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const FuzzCase c =
        make_case(seed, {Profile::fed_back, Arithmetic::rational, Collapse::keep, 0.001});
    CHECK(c.profile == "fed_back");
    CHECK(c.operations.size() >= 18);
    CHECK(c.options.arithmetic == Arithmetic::rational);
    CHECK(c.options.collapse == Collapse::keep);
    CHECK(c.options.jitter == 0.001);
  }
}

TEST_CASE("half of the cases are hostile, one in 64 is large, and all generators occur alike") {
  constexpr int kSeeds = 3000;
  std::map<std::string, int> profiles, made_by;
  int large = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const FuzzCase c = make_case(seed, {});
    ++profiles[c.profile];
    ++made_by[c.generator];
    large += c.surface.triangles.size() > 1500 ? 1 : 0;
  }
  CHECK(profiles.size() == 3);
  CHECK(profiles["hostile"] / double{kSeeds} == Approx(0.5).margin(0.04));
  CHECK(profiles["random"] / double{kSeeds} == Approx(0.25).margin(0.04));
  CHECK(made_by.size() == generators().size());
  for (const auto& [name, count] : made_by)
    CHECK(count * static_cast<double>(generators().size()) / kSeeds == Approx(1).margin(0.3));
  CHECK(large > kSeeds / 64 / 4);
  CHECK(large < kSeeds / 64 * 2);
}

TEST_CASE("an option more is drawn without a change to anything else") {
  CaseParts more = case_parts();
  more.options.insert(more.options.begin(), {"tracker.most_restarts", Whole{1, 50}, 2});
  int drawn = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const FuzzCase before = make_case(seed, {});
    FuzzCase after = make_case(seed, {}, more);
    drawn += before.options.most_restarts != after.options.most_restarts ? 1 : 0;
    after.options.most_restarts = before.options.most_restarts;
    CHECK(text_of(before) == text_of(after));
  }
  CHECK(drawn > 60);
  CHECK(drawn < 140);
}

TEST_CASE("a generator more takes its share of the cases, and leaves the others as they were") {
  CaseParts more = case_parts();
  more.generators.insert(more.generators.begin() + 5, {"a ball", a_ball});
  constexpr int kSeeds = 600;
  int taken = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const FuzzCase before = make_case(seed, {});
    FuzzCase after = make_case(seed, {}, more);
    if (after.generator == "a ball") {
      ++taken;
      CHECK(before.operations.size() == after.operations.size());
      after.surface = before.surface;
      after.generator = before.generator;
    }
    CHECK(text_of(before) == text_of(after));
  }
  CHECK(taken * static_cast<double>(more.generators.size()) / kSeeds == Approx(1).margin(0.5));
}

TEST_CASE("a motion more takes its share of the operations, and leaves all else as it was") {
  CaseParts more = case_parts();
  more.motions.emplace_back("a new one");
  int taken = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const FuzzCase before = make_case(seed, {});
    FuzzCase after = make_case(seed, {}, more);
    REQUIRE(before.operations.size() == after.operations.size());
    for (std::size_t i = 0; i < after.operations.size(); ++i) {
      const auto motion = after.operations[i].values.find("motion");
      if (motion == after.operations[i].values.end() || motion->second != Value("a new one"))
        continue;
      ++taken;
      after.operations[i] = before.operations[i];
    }
    CHECK(text_of(before) == text_of(after));
  }
  CHECK(taken > 50);
}

TEST_CASE("the profile decides what is done to a surface, not which surface it is") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const FuzzCase random = make_case(seed, {Profile::random});
    const FuzzCase hostile = make_case(seed, {Profile::hostile});
    CHECK(random.generator == hostile.generator);
    CHECK(random.surface.triangles == hostile.surface.triangles);
  }
}
