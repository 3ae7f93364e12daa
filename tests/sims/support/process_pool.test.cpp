// Work in processes of its own.
#include "sims/support/process_pool.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <map>
#include <numeric>

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

namespace {

std::map<std::size_t, Ended> ended(std::size_t count, const ProcessOptions& options,
                                   const std::function<std::string(std::size_t)>& work) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::map<std::size_t, Ended> all;
  in_processes(order, options, work,
               [&](std::size_t i, const Ended& e) { CHECK(all.emplace(i, e).second); });
  return all;
}

}  // namespace

TEST_CASE("what work returns comes back from its process, whatever its length and bytes") {
  const auto work = [](std::size_t i) { return std::string(i * 70000, 'x') + '\n' + '\0'; };
  for (const int jobs : {1, 4}) {
    const auto all = ended(5, {.jobs = jobs}, work);
    REQUIRE(all.size() == 5);
    for (const auto& [i, e] : all) {
      CHECK(e.finished);
      CHECK(e.said == work(i));
      CHECK(e.words().empty());
    }
  }
}

TEST_CASE("a crash, an exception and a silent exit end only their own process") {
  const auto all = ended(4, {}, [](std::size_t i) -> std::string {
    if (i == 0) std::raise(SIGSEGV);
    if (i == 1) throw 1;
    if (i == 2) _exit(0);
    return "well";
  });
  REQUIRE(all.size() == 4);
  CHECK(all.at(0).signal == SIGSEGV);
  CHECK_THAT(all.at(0).words(), Contains("signal 11"));
  CHECK(all.at(1).signal == SIGABRT);
  CHECK_FALSE(all.at(2).finished);
  CHECK_THAT(all.at(2).words(), Contains("without a result"));
  CHECK(all.at(3).said == "well");
}

TEST_CASE("work that sleeps or spins is ended when its time is over") {
  const auto all = ended(3, {.jobs = 3, .limit_seconds = 0.05}, [](std::size_t i) -> std::string {
    const auto start = std::chrono::steady_clock::now();
    while (i == 0 && std::chrono::steady_clock::now() - start < std::chrono::seconds(60)) {
    }
    if (i == 1) sleep(60);
    return "well";
  });
  REQUIRE(all.size() == 3);
  CHECK(all.at(0).out_of_time);
  CHECK(all.at(1).out_of_time);
  CHECK_THAT(all.at(1).words(), Contains("out of time"));
  CHECK(all.at(2).finished);
}

TEST_CASE("a process's peak memory is its own") {
  const auto all = ended(2, {}, [](std::size_t i) {
    forget_peak();
    const double before = peak_megabytes();
    const std::vector<char> held(i * 200000000, 'x');
    return std::to_string(peak_megabytes() - before + (held.empty() ? 0 : held.back() - 'x'));
  });
  CHECK(std::stod(all.at(0).said) < 50);
  CHECK(std::stod(all.at(1).said) == Approx(200).epsilon(0.1));
}
