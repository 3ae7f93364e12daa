#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "kernel/errors.h"
#include "sims/fuzz/campaign.h"
#include "tests/sims/fuzz/counted.h"

using namespace suture;
using namespace suture::sims;

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
    CHECK(s.failures[0].check == "crash");
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
  CHECK(s.failures[0].check == "hang");
  CHECK(s.failures[1].seed == 70);
  CHECK(s.failures[1].check == "hang");
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

TEST_CASE("a fixed budget of cases passes every check") {
  const FuzzSummary s = run_campaign(
      {.first = 1000000, .cases = 1500, .jobs = 2},
      [](std::uint64_t seed) { return run_case(make_case(seed, {}), CheckChoice()).counts; });
  for (const FuzzFailure& f : s.failures) {
    CAPTURE(f.seed, f.check, f.cause);
    CHECK(false);
  }
  WARN(s.surgeries << " of " << s.remodels << " remodels changed the mesh, in " << s.cpu_seconds
                   << " s of one core");
  CHECK(s.surgeries > 2000);
}
