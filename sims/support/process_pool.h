// Work done in processes of its own: what crashes, hangs or eats memory there, ends only there.
#pragma once

#include <cstdint>
#include <optional>

#include "sims/support/process.h"

namespace suture::sims {

/// The limits of processes.
struct ProcessOptions {
  int jobs = 1;  ///< processes at a time, >= 1
  /// CPU seconds between two messages after which one is ended, as it hangs. By the clock it has
  /// ten times that and a second more, so that one that only waits for its turn does not hang.
  double limit_seconds = std::numeric_limits<double>::infinity();
  double limit_megabytes = std::numeric_limits<double>::infinity();  ///< of addresses, in 10⁶ bytes
};

/// Work for a process of its own. What it throws ends it, as Process says: catch what has a
/// meaning.
struct ProcessTask {
  std::size_t id = 0;  ///< by which the client knows it
  std::function<void(const Say&)> work;
};

/// Hands out tasks, and hears what they come to: as it is said, or when they end.
class PoolClient {
 public:
  virtual ~PoolClient() = default;
  virtual std::optional<ProcessTask> next() = 0;  ///< none: there is nothing to start now
  virtual void heard(std::size_t /*id*/, const std::string& /*message*/) {}
  virtual void ended(std::size_t id, const Ended& how) = 0;
  virtual void waited() {}  ///< some ten times a second, and whenever something was heard
};

/// Runs the client's tasks until it has none and all have ended. Messages of a task come in their
/// order; tasks end in any. \pre this process has one thread \throw InvalidInput if the system
/// allows no further process; what the client throws ends all tasks
void run_pool(PoolClient& client, const ProcessOptions& options);

/// Calls work() in a process, whose only message is what it returns.
Ended in_process(const ProcessOptions& options, const std::function<std::string()>& work);

}  // namespace suture::sims
