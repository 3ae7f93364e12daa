// Work done in processes of its own: what crashes, hangs or eats memory there, ends only there.
#include "sims/support/process_pool.h"

#include <poll.h>

#include <algorithm>
#include <list>
#include <utility>

#include "sims/support/clock.h"

namespace suture::sims {
namespace {

/// A task at work, and where it was when it was last heard.
struct Worker {
  std::size_t id;
  Process process;
  double since = wall_seconds(), cpu_since = 0;
  std::optional<std::string> said = {};  ///< last

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
      w.said = std::move(messages.back());
      w.since = wall_seconds();
      w.cpu_since = w.process.cpu_seconds();
    }
    const bool hangs = talks && w.hangs(options_.limit_seconds);
    if (talks && !hangs) return true;
    if (hangs) w.process.kill();
    Ended ended = w.process.wait();
    ended.out_of_time = hangs;
    ended.finished = ended.finished && !hangs && w.said;
    if (ended.finished) ended.said = std::move(*w.said);
    client_.ended(w.id, ended);
    return false;
  }

  PoolClient& client_;
  const ProcessOptions& options_;
  std::list<Worker> workers_;
};

/// The client of a single task, whose only message is its result.
class Single : public PoolClient {
 public:
  explicit Single(const std::function<std::string()>& work) : work_(work) {}
  Ended how;

 private:
  std::optional<ProcessTask> next() override {
    if (std::exchange(begun_, true)) return std::nullopt;
    return ProcessTask{0, [this](const Say& say) { say(work_()); }};
  }
  void ended(std::size_t /*id*/, const Ended& with) override { how = with; }

  const std::function<std::string()>& work_;
  bool begun_ = false;
};

}  // namespace

void run_pool(PoolClient& client, const ProcessOptions& options) { Pool(client, options).run(); }

Ended in_process(const ProcessOptions& options, const std::function<std::string()>& work) {
  Single client(work);
  run_pool(client, options);
  return client.how;
}

}  // namespace suture::sims
