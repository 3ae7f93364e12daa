#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>

#include "kernel/errors.h"
#include "sims/fuzz/campaign.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/execute.h"

using namespace suture;
using namespace suture::sims;

namespace {

/// A stand-in for a case that does nothing but count.
FuzzSummary counted(std::uint64_t seed) {
  FuzzSummary one;
  one.cases = 1;
  one.surgeries = 2;
  one.digest = seed * seed;
  one.refused["a cause"] = 1;
  return one;
}

FuzzSummary real(std::uint64_t seed) {
  return run_case(make_case(seed, {}), OracleChoice("fast")).counts;
}

nlohmann::json without_seconds(const FuzzSummary& summary) {
  nlohmann::json json = to_json(summary);
  for (const char* key :
       {"cpu_seconds", "wall_seconds", "surgeries_per_second", "surgeries_per_cpu_second"})
    json.erase(key);
  return json;
}

}  // namespace

TEST_CASE("a campaign comes to the same on one worker and on three") {
  CampaignOptions options{.first = 100, .cases = 300};
  const FuzzSummary one = run_campaign(options, real);
  options.jobs = 3;
  const FuzzSummary three = run_campaign(options, real);
  CHECK(without_seconds(one) == without_seconds(three));
  CHECK(one.cases == 300);
  CHECK(one.surgeries > 100);
  CHECK(one.digest != 0);
  CHECK(one.failures.empty());
}

TEST_CASE("two halves of a campaign merge to the whole, through their JSON") {
  FuzzSummary whole = run_campaign({.first = 1, .cases = 150}, real);
  FuzzSummary sum = summary_from_json(to_json(run_campaign({.first = 81, .cases = 70}, real)), "b");
  merge(sum, summary_from_json(to_json(run_campaign({.first = 1, .cases = 80}, real)), "a"));
  CHECK(without_seconds(sum) == without_seconds(whole));
}

TEST_CASE("summaries that share seeds or differ in what was asked are not merged") {
  FuzzSummary a = run_campaign({.first = 1, .cases = 10}, counted);
  FuzzSummary b = run_campaign({.first = 10, .cases = 10}, counted);
  CHECK_THROWS_AS(merge(a, b), InvalidInput);
  FuzzSummary c = run_campaign({.first = 11, .cases = 10}, counted);
  c.settings.arithmetic = "rounded";
  CHECK_THROWS_AS(merge(a, c), InvalidInput);
  c.settings = a.settings;
  merge(a, c);
  CHECK(a.cases == 20);
  CHECK(a.seeds.size() == 1);
  CHECK(a.refused["a cause"] == 20);
  CHECK_THROWS_AS(summary_from_json(nlohmann::json{{"cases", 3}}, "x"), InvalidInput);
}

TEST_CASE("a case that kills its worker is a crash of that seed, and the others go on") {
  for (const int jobs : {1, 2}) {
    const FuzzSummary s =
        run_campaign({.first = 1, .cases = 200, .jobs = jobs}, [](std::uint64_t seed) {
          if (seed == 17) {
            std::signal(SIGSEGV, SIG_DFL);  // not the test program's
            std::raise(SIGSEGV);
          }
          if (seed == 60) std::raise(SIGKILL);
          if (seed == 130) _exit(9);
          if (seed == 131) throw std::runtime_error("planted");
          return counted(seed);
        });
    CHECK(s.cases == 200);
    CHECK(s.surgeries == 2 * 196);
    REQUIRE(s.failures.size() == 4);
    CHECK(s.failures[0].seed == 17);
    CHECK(s.failures[0].oracle == "crash");
    CHECK(s.failures[0].cause.find("signal 11") != std::string::npos);
    CHECK(s.failures[1].seed == 60);
    CHECK(s.failures[2].seed == 130);
    CHECK(s.failures[2].cause.find("exit code 9") != std::string::npos);
    CHECK(s.failures[3].seed == 131);
    CHECK(to_json(s)["crashes"] == 4);
  }
}

TEST_CASE("a case that never ends is a hang of that seed, and the others go on") {
  const FuzzSummary s = run_campaign({.first = 1, .cases = 100, .jobs = 2, .case_seconds = 0.2},
                                     [](std::uint64_t seed) {
                                       for (volatile int x = 0; seed == 40;) x = 1 - x;
                                       while (seed == 70) usleep(1000);
                                       return counted(seed);
                                     });
  CHECK(s.cases == 100);
  CHECK(s.surgeries == 2 * 98);
  REQUIRE(s.failures.size() == 2);
  CHECK(s.failures[0].seed == 40);
  CHECK(s.failures[0].oracle == "hang");
  CHECK(s.failures[1].seed == 70);
  CHECK(s.failures[1].oracle == "hang");
}

TEST_CASE("time ends a campaign after whole batches, so that its seeds are one range") {
  const FuzzSummary s = run_campaign({.first = 5, .seconds = 0.3, .jobs = 2}, counted);
  REQUIRE(s.seeds.size() == 1);
  CHECK(s.seeds[0].first == 5);
  CHECK(s.seeds[0].cases == s.cases);
  CHECK(s.cases > 0);
}

TEST_CASE("a campaign without an end, or with nonsense for numbers, is refused") {
  CHECK_THROWS_AS(run_campaign({.first = 1}, counted), InvalidInput);
  CHECK_THROWS_AS(run_campaign({.first = 1, .cases = 1, .jobs = 0}, counted), InvalidInput);
  CHECK_THROWS_AS(run_campaign({.first = UINT64_MAX - 3, .cases = 10}, counted), InvalidInput);
  CHECK_THROWS_AS(run_campaign({.first = 1, .cases = 1, .case_seconds = 0}, counted), InvalidInput);
}

TEST_CASE("causes that differ in numbers only are one kind") {
  CHECK(kind_of_cause("audit: edge 12-7 has 3 triangles\nmore") ==
        "audit: edge #-# has # triangles");
}

TEST_CASE("a fixed budget of cases passes every oracle") {
  const FuzzSummary s = run_campaign(
      {.first = 1000000, .cases = 1500, .jobs = 2},
      [](std::uint64_t seed) { return run_case(make_case(seed, {}), OracleChoice()).counts; });
  for (const FuzzFailure& f : s.failures) {
    CAPTURE(f.seed, f.oracle, f.cause);
    CHECK(false);
  }
  WARN(s.surgeries << " of " << s.remodels << " remodels changed the mesh, in " << s.cpu_seconds
                   << " s of one core");
  CHECK(s.surgeries > 2000);
}
