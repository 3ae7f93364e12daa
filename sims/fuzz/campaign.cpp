// Batches of seeds go to workers of a process pool in order; each says what a case came to.
#include "sims/fuzz/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "kernel/errors.h"
#include "sims/support/clock.h"
#include "sims/support/process_pool.h"

namespace suture::sims {

namespace {

constexpr std::uint64_t kBatch = 64;

FuzzSummary death_of(std::uint64_t seed, const std::string& check, const std::string& cause) {
  FuzzSummary one;
  one.cases = 1;
  one.failures.push_back({seed, check, cause, {}});
  return one;
}

class Campaign : public PoolClient {
 public:
  Campaign(const CampaignOptions& options, const CaseRunner& run, const CampaignWatcher& watcher)
      : options_(options), run_(run), watcher_(watcher), next_(options.first) {}

  FuzzSummary go() {
    run_pool(*this, {.jobs = options_.jobs, .limit_seconds = options_.case_seconds});
    sum_.wall_seconds = watch_.seconds();
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
    if (options_.seconds > 0 && watch_.seconds() >= options_.seconds) return std::nullopt;
    const std::uint64_t done = next_ - options_.first;
    const std::uint64_t left = options_.cases == 0 ? kBatch : options_.cases - done;
    if (left == 0) return std::nullopt;
    const SeedRange range{next_, std::min(left, kBatch)};
    next_ += range.cases;
    return range;
  }

  /// A task is a range of seeds, and says what each case came to.
  std::optional<ProcessTask> next() override {
    const auto range = next_range();
    if (!range) return std::nullopt;
    left_.emplace(++tasks_, *range);
    return ProcessTask{tasks_, [this, r = *range](const Say& say) {
                         for (std::uint64_t i = 0; i < r.cases; ++i)
                           say(to_json(run_(r.first + i)).dump());
                       }};
  }

  void heard(std::size_t task, const std::string& message) override {
    add_counts(sum_, summary_from_json(nlohmann::json::parse(message), "a worker's line"));
    SeedRange& range = left_.at(task);
    ++range.first;
    --range.cases;
  }

  /// Another worker does the work that one left undone, but for the case that ended it.
  void ended(std::size_t task, const Ended& how) override {
    sum_.cpu_seconds += how.cpu_seconds;
    const SeedRange range = left_.at(task);
    left_.erase(task);
    if (range.cases == 0) return;
    add_counts(sum_, how.out_of_time ? death_of(range.first, "hang",
                                                fmt::format("took more than {} s of a core",
                                                            options_.case_seconds))
                                     : death_of(range.first, "crash", how.words()));
    if (range.cases > 1) again_.push_back({range.first + 1, range.cases - 1});
  }

  void waited() override {
    if (watcher_) watcher_(sum_, watch_.seconds());
  }

  const CampaignOptions& options_;
  const CaseRunner& run_;
  const CampaignWatcher& watcher_;
  std::uint64_t next_;
  std::deque<SeedRange> again_;
  std::size_t tasks_ = 0;
  std::map<std::size_t, SeedRange> left_;  ///< of each task, what it has not done yet
  FuzzSummary sum_;
  const Lap watch_{wall_seconds};
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
