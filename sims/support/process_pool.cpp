// Work done in processes of its own: what crashes, hangs or eats memory there, ends only there.
#include "sims/support/process_pool.h"

#include <poll.h>

#include <algorithm>
#include <list>

#include "sims/support/clock.h"

namespace suture::sims {
namespace {

/// A task at work, and where it was when it was last heard.
struct Worker {
  std::size_t id;
  Process process;
  double since = wall_seconds(), cpu_since = 0;

  bool hangs(double allowed) const {
    constexpr double kPatience = 10;  // seconds by the clock for each CPU second that is allowed
    return process.cpu_seconds() - cpu_since > allowed ||
           wall_seconds() - since > kPatience * allowed + 1;
  }
};

class Pool {
 public:
  Pool(PoolClient& client, const ProcessOptions& options) : client_(client), options_(options) {}

  void run() {
    while (true) {
      while (workers_.size() < static_cast<std::size_t>(options_.jobs) && start()) {
      }
      if (workers_.empty()) return;
      wait();
      for (auto w = workers_.begin(); w != workers_.end();)
        w = attend(*w) ? std::next(w) : workers_.erase(w);
      client_.waited();
    }
  }

 private:
  bool start() {
    const std::optional<ProcessTask> task = client_.next();
    if (!task) return false;
    workers_.push_back({task->id, Process(task->work, options_.limit_megabytes)});
    return true;
  }

  void wait() const {
    std::vector<pollfd> pipes;
    for (const Worker& w : workers_) pipes.push_back({w.process.pipe(), POLLIN, 0});
    const double milliseconds = 1 + std::min(100.0, 500 * options_.limit_seconds);
    poll(pipes.data(), pipes.size(), static_cast<int>(milliseconds));
  }

  /// \return whether the worker still runs
  bool attend(Worker& w) {
    std::vector<std::string> messages;
    const bool talks = w.process.hear(messages);
    for (const std::string& message : messages) client_.heard(w.id, message);
    if (!messages.empty()) {
      w.since = wall_seconds();
      w.cpu_since = w.process.cpu_seconds();
    }
    const bool hangs = talks && w.hangs(options_.limit_seconds);
    if (talks && !hangs) return true;
    if (hangs) w.process.kill();
    Ended ended = w.process.wait();
    ended.out_of_time = hangs;
    ended.finished = ended.finished && !hangs;
    client_.ended(w.id, ended);
    return false;
  }

  PoolClient& client_;
  const ProcessOptions& options_;
  std::list<Worker> workers_;
};

/// Tasks of one result each.
class Results : public PoolClient {
 public:
  using Work = std::function<std::string(std::size_t)>;
  using Told = std::function<void(std::size_t, const Ended&)>;
  Results(const std::vector<std::size_t>& order, const Work& work, const Told& told)
      : order_(order), work_(work), told_(told), said_(order.size()) {}

  std::optional<ProcessTask> next() override {
    if (next_ == order_.size()) return std::nullopt;
    const std::size_t index = order_[next_];
    return ProcessTask{next_++, [this, index](const Say& say) { say(work_(index)); }};
  }
  void heard(std::size_t id, const std::string& message) override { said_[id] = message; }
  void ended(std::size_t id, const Ended& how) override {
    Ended with = how;
    with.finished = how.finished && said_[id];
    if (with.finished) with.said = std::move(*said_[id]);
    told_(order_[id], with);
  }

 private:
  const std::vector<std::size_t>& order_;
  const Work& work_;
  const Told& told_;
  std::size_t next_ = 0;
  std::vector<std::optional<std::string>> said_;  ///< by each, if it has come
};

}  // namespace

void run_pool(PoolClient& client, const ProcessOptions& options) { Pool(client, options).run(); }

void in_processes(const std::vector<std::size_t>& order, const ProcessOptions& options,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, const Ended&)>& ended) {
  Results results(order, work, ended);
  run_pool(results, options);
}

Ended in_process(const ProcessOptions& options, const std::function<std::string()>& work) {
  Ended result;
  in_processes(
      {0}, options, [&](std::size_t) { return work(); },
      [&](std::size_t, const Ended& ended) { result = ended; });
  return result;
}

}  // namespace suture::sims
