// Batches of seeds go to forked workers in order. A worker says when a case begins and ends.
#include "sims/fuzz/campaign.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <list>
#include <nlohmann/json.hpp>
#include <optional>

#include "kernel/errors.h"
#include "kernel/trace.h"
#include "sims/support/process.h"

namespace suture::sims {

namespace {

constexpr std::uint64_t kBatch = 64;

/// A worker, its range of seeds, and the case that it has begun.
struct Worker {
  Child child;
  SeedRange range;                       ///< not yet done
  std::optional<std::uint64_t> running;  ///< the seed it is at
  double since = 0, cpu_since = 0;       ///< when that began, and the core's seconds until then
  bool hung = false;
  std::string unread;
};

FuzzSummary death_of(std::uint64_t seed, const std::string& check, const std::string& cause) {
  FuzzSummary one;
  one.cases = 1;
  one.failures.push_back({seed, check, cause, {}});
  return one;
}

class Campaign {
 public:
  Campaign(const CampaignOptions& options, const CaseRunner& run, const CampaignWatcher& watcher)
      : options_(options), run_(run), watcher_(watcher), next_(options.first) {}

  FuzzSummary go() {
    while (true) {
      while (workers_.size() < static_cast<std::size_t>(options_.jobs) && start_worker()) {
      }
      if (workers_.empty()) break;
      listen();
      now_ += watch_.lap();
      for (auto w = workers_.begin(); w != workers_.end();) w = attend(*w) ? std::next(w) : end(w);
      if (watcher_) watcher_(sum_, now_);
    }
    sum_.wall_seconds = now_;
    if (next_ != options_.first) sum_.seeds = {{options_.first, next_ - options_.first}};
    return std::move(sum_);
  }

 private:
  std::optional<SeedRange> next_range() {
    if (!again_.empty()) {
      const SeedRange range = again_.front();
      again_.pop_front();
      return range;
    }
    if (options_.seconds > 0 && now_ >= options_.seconds) return std::nullopt;
    const std::uint64_t done = next_ - options_.first;
    const std::uint64_t left = options_.cases == 0 ? kBatch : options_.cases - done;
    if (left == 0) return std::nullopt;
    const SeedRange range{next_, std::min(left, kBatch)};
    next_ += range.cases;
    return range;
  }

  bool start_worker() {
    const auto range = next_range();
    if (!range) return false;
    workers_.push_back({Child([this, r = *range](int fd) {
                          for (std::uint64_t i = 0; i < r.cases; ++i) {
                            write_all(fd, fmt::format("{}\n", r.first + i));
                            write_all(fd, to_json(run_(r.first + i)).dump() + "\n");
                          }
                        }),
                        *range,
                        std::nullopt,
                        now_,
                        0,
                        false,
                        {}});
    return true;
  }

  void listen() {
    std::vector<pollfd> ends;
    for (const Worker& w : workers_) ends.push_back({w.child.fd(), POLLIN, 0});
    const double milliseconds = 1 + std::min(100.0, 500 * options_.case_seconds);
    poll(ends.data(), ends.size(), static_cast<int>(milliseconds));
  }

  /// Reads what a worker says. \return whether it still runs
  bool attend(Worker& w) {
    char buffer[65536];
    ssize_t n = 0;
    while ((n = ::read(w.child.fd(), buffer, sizeof buffer)) > 0)
      w.unread.append(buffer, static_cast<std::size_t>(n));
    std::size_t from = 0;
    for (std::size_t to; (to = w.unread.find('\n', from)) != std::string::npos; from = to + 1)
      hear(w, w.unread.substr(from, to - from));
    w.unread.erase(0, from);
    if (n == 0) return false;
    if (w.running &&
        hangs(w.child.cpu_seconds() - w.cpu_since, now_ - w.since, options_.case_seconds)) {
      w.child.kill();
      w.hung = true;
      return false;
    }
    return true;
  }

  void hear(Worker& w, const std::string& line) {
    if (line[0] != '{') {
      w.running = std::stoull(line);
      w.since = now_;
      w.cpu_since = w.child.cpu_seconds();
      return;
    }
    add_counts(sum_, summary_from_json(nlohmann::json::parse(line), "a worker's line"));
    w.running.reset();
    ++w.range.first;
    --w.range.cases;
  }

  /// A worker has ended or must; what it left undone is done by another.
  std::list<Worker>::iterator end(std::list<Worker>::iterator w) {
    const std::string death = w->child.wait();
    sum_.cpu_seconds += w->child.cpu_seconds();
    if (w->range.cases > 0) {
      const std::uint64_t seed = w->range.first;
      add_counts(sum_, w->hung ? death_of(seed, "hang",
                                          fmt::format("took more than {} s of a core",
                                                      options_.case_seconds))
                               : death_of(seed, "crash", death.empty() ? "ended early" : death));
      if (w->range.cases > 1) again_.push_back({seed + 1, w->range.cases - 1});
    }
    return workers_.erase(w);
  }

  const CampaignOptions& options_;
  const CaseRunner& run_;
  const CampaignWatcher& watcher_;
  std::uint64_t next_;
  std::deque<SeedRange> again_;
  std::list<Worker> workers_;
  FuzzSummary sum_;
  Stopwatch watch_;
  double now_ = 0;
};

}  // namespace

FuzzSummary run_campaign(const CampaignOptions& options, const CaseRunner& run,
                         const CampaignWatcher& watcher) {
  if (options.cases == 0 && !(options.seconds > 0))
    throw InvalidInput("a campaign needs an end; give a number of cases, a time, or both");
  if (options.cases > UINT64_MAX - options.first)
    throw InvalidInput("the seeds would pass 2^64; give a smaller first seed or fewer cases");
  constexpr int kMostJobs = 1024;
  if (options.jobs < 1 || options.jobs > kMostJobs)
    throw InvalidInput(fmt::format("jobs is {}; give 1 to {}", options.jobs, kMostJobs));
  if (!(options.case_seconds > 0) || !std::isfinite(options.seconds))
    throw InvalidInput("the seconds must be finite, and those for a case above zero");
  return Campaign(options, run, watcher).go();
}

}  // namespace suture::sims
