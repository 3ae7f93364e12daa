// Work in processes of its own.
#include "sims/support/process_pool.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <map>
#include <stdexcept>
#include <utility>

#include "sims/support/clock.h"

using namespace suture;
using namespace suture::sims;
using Catch::Matchers::Contains;

namespace {

using Work = std::function<std::string(std::size_t)>;

/// A client whose tasks, by their numbers, have one result each.
class Numbered : public PoolClient {
 public:
  Numbered(std::size_t count, Work work) : count_(count), work_(std::move(work)) {}
  std::map<std::size_t, Ended> all;

 private:
  std::optional<ProcessTask> next() override {
    if (next_ == count_) return std::nullopt;
    const std::size_t i = next_++;
    return ProcessTask{i, [this, i](const Say& say) { say(work_(i)); }};
  }
  void ended(std::size_t i, const Ended& e) override { CHECK(all.emplace(i, e).second); }

  std::size_t count_;
  Work work_;
  std::size_t next_ = 0;
};

std::map<std::size_t, Ended> ended(std::size_t count, const ProcessOptions& options,
                                   const Work& work) {
  Numbered client(count, work);
  run_pool(client, options);
  return client.all;
}

/// A client whose tasks count to their own number, a message each, and may end badly after it.
class Counting : public PoolClient {
 public:
  explicit Counting(std::vector<std::function<void()>> ends) : ends_(std::move(ends)) {}
  std::map<std::size_t, std::vector<std::string>> said;
  std::map<std::size_t, Ended> over;
  int waits = 0;

 private:
  std::optional<ProcessTask> next() override {
    if (next_ == ends_.size()) return std::nullopt;
    const std::size_t id = next_++;
    return ProcessTask{id, [this, id](const Say& say) {
                         for (std::size_t i = 0; i <= id; ++i) say(std::to_string(i));
                         ends_[id]();
                       }};
  }
  void heard(std::size_t id, const std::string& message) override { said[id].push_back(message); }
  void ended(std::size_t id, const Ended& how) override { over[id] = how; }
  void waited() override { ++waits; }

  std::vector<std::function<void()>> ends_;
  std::size_t next_ = 0;
};

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
    const Lap lap(wall_seconds);
    while (i == 0 && lap.seconds() < 60) {
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

TEST_CASE("a task's messages come whole and in order, even if it crashes or hangs after them") {
  const auto well = [] {};
  Counting client({well, [] { std::raise(SIGKILL); }, well, [] { sleep(60); },
                   [] { throw std::runtime_error("planted"); }});
  run_pool(client, {.jobs = 2, .limit_seconds = 0.1});
  REQUIRE(client.over.size() == 5);
  for (std::size_t id = 0; id < 5; ++id) {
    REQUIRE(client.said[id].size() == id + 1);
    for (std::size_t i = 0; i <= id; ++i) CHECK(client.said[id][i] == std::to_string(i));
    CHECK(client.over[id].finished == (id % 2 == 0 && id < 4));
  }
  CHECK(client.over[1].signal == SIGKILL);
  CHECK_FALSE(client.over[1].out_of_time);
  CHECK(client.over[3].out_of_time);
  CHECK(client.over[4].words() == "ended with exit code 3");
  CHECK(client.waits >= 5);
}

TEST_CASE("time counts from a task's last message, so that steady work may go on") {
  std::vector<std::string> said;
  Ended how;
  class Steady : public PoolClient {
   public:
    Steady(std::vector<std::string>& said, Ended& how) : said_(said), how_(how) {}

   private:
    std::optional<ProcessTask> next() override {
      if (std::exchange(begun_, true)) return std::nullopt;
      return ProcessTask{0, [](const Say& say) {
                           for (int i = 0; i < 8; ++i) {
                             const Lap lap;
                             while (lap.seconds() < 0.1) {
                             }
                             say("on");
                           }
                         }};
    }
    void heard(std::size_t, const std::string& message) override { said_.push_back(message); }
    void ended(std::size_t, const Ended& how) override { how_ = how; }
    std::vector<std::string>& said_;
    Ended& how_;
    bool begun_ = false;
  } client(said, how);
  run_pool(client, {.limit_seconds = 0.4});
  CHECK(how.finished);
  CHECK(said.size() == 8);
  CHECK(how.cpu_seconds > 0.7);
}

TEST_CASE("memory beyond the limit is refused to the process that asks for it") {
  const auto hold = [](std::size_t bytes) {
    return in_process({.limit_megabytes = 4000}, [bytes] {
      const std::vector<char> held(bytes, 'x');
      return std::string(1, held[bytes / 2]);
    });
  };
  CHECK(hold(100000000).said == "x");
  const Ended refused = hold(5000000000);
  CHECK_FALSE(refused.finished);
  CHECK(refused.words() == "ended with exit code 3");
}

TEST_CASE("a client that throws ends its tasks") {
  class Throwing : public PoolClient {
    std::optional<ProcessTask> next() override {
      return ProcessTask{0, [](const Say& say) {
                           say("on");
                           sleep(60);
                         }};
    }
    void heard(std::size_t, const std::string&) override { throw std::runtime_error("planted"); }
    void ended(std::size_t, const Ended&) override {}
  } client;
  const Lap lap(wall_seconds);
  CHECK_THROWS_AS(run_pool(client, {.jobs = 3}), std::runtime_error);
  CHECK(lap.seconds() < 30);
}
