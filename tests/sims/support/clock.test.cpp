// Clocks, laps, costs and memory.
#include "sims/support/clock.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

using namespace suture::sims;

namespace {

/// Keeps a core busy for so many CPU seconds.
void work_for(double seconds) {
  const Lap lap;
  volatile double x = 1;
  while (lap.seconds() < seconds) x = x + 1;
}

}  // namespace

TEST_CASE("sleep passes by the clock and costs no CPU") {
  Lap wall(wall_seconds), cpu;
  usleep(200000);
  CHECK(cpu.next() < 0.1);
  CHECK(wall.next() >= 0.2);
  work_for(0.05);
  CHECK(cpu.next() >= 0.05);
  CHECK(wall.seconds() > 0);
}

TEST_CASE("costs add up by part and by name, in the order in which these were given") {
  Costs costs{{{"move", 0}, {"remodel", 0}}, {{"remodels", 0}}};
  costs.timed("remodel", [] { work_for(0.02); });
  const int got = costs.timed("move", [] {
    work_for(0.01);
    return 7;
  });
  costs.timed("remodel", [] { work_for(0.02); });
  costs.count("remodels");
  costs.count("remodels");
  costs.count("flips", 5);
  CHECK(got == 7);
  REQUIRE(costs.seconds.size() == 2);
  CHECK(costs.seconds[0].first == "move");
  CHECK(costs.seconds_of("remodel") >= 0.04);
  CHECK(costs.seconds_of("move") >= 0.01);
  CHECK(costs.counts == Costs::List{{"remodels", 2}, {"flips", 5}});
  CHECK(std::isnan(costs.count_of("nothing")));
}

TEST_CASE("work that throws has cost what it took until then") {
  Costs costs;
  CHECK_THROWS_AS(costs.timed("work",
                              [] {
                                work_for(0.02);
                                throw std::runtime_error("planted");
                              }),
                  std::runtime_error);
  CHECK(costs.seconds_of("work") >= 0.02);
}
