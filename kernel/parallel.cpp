// The only file that meets oneTBB; without SUTURE_TBB all blocks run in order on the caller.
#include "kernel/parallel.h"

#ifdef SUTURE_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <atomic>
#include <exception>
#include <mutex>
#include <string>

#include "kernel/errors.h"

namespace suture {

namespace {

/// The blocks of one loop.
struct Blocks {
  std::size_t count, grain;
  const std::function<void(IndexRange)>& body;

  std::size_t size() const { return count / grain + (count % grain != 0 ? 1 : 0); }
  void run(std::size_t block) const {
    const std::size_t begin = block * grain;
    body({begin, count - begin < grain ? count : begin + grain});
  }
};

}  // namespace

#ifdef SUTURE_TBB

namespace {

/// The exception of the lowest block that threw. Blocks above it need not run, those below it must.
class FirstFailure {
 public:
  bool before(std::size_t block) const { return block_.load(std::memory_order_relaxed) < block; }
  void note(std::size_t block) {
    const std::lock_guard lock(mutex_);
    if (block_.load(std::memory_order_relaxed) <= block) return;
    block_.store(block, std::memory_order_relaxed);
    what_ = std::current_exception();
  }
  void rethrow() const {
    if (what_) std::rethrow_exception(what_);
  }

 private:
  std::atomic<std::size_t> block_ = static_cast<std::size_t>(-1);
  std::exception_ptr what_;
  std::mutex mutex_;
};

void run_on_threads(const Blocks& blocks) {
  FirstFailure failure;
  // The workers take over the floating-point mode that the caller has here.
  tbb::task_group_context context(
      tbb::task_group_context::bound,
      tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  const auto run = [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t b = range.begin(); b < range.end(); ++b) {
      if (failure.before(b)) continue;
      try {
        blocks.run(b);
      } catch (...) {
        failure.note(b);
      }
    }
  };
  // A thread that waits here for others takes no block of a loop outside this one meanwhile.
  tbb::this_task_arena::isolate(
      [&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size()), run, context); });
  failure.rethrow();
}

std::size_t allowed_threads() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

}  // namespace

void parallel_blocks(std::size_t count, std::size_t grain,
                     const std::function<void(IndexRange)>& body) {
  const Blocks blocks{count, grain, body};
  if (blocks.size() == 0) return;
  if (blocks.size() == 1) return blocks.run(0);
  const int allowed = static_cast<int>(allowed_threads());
  if (allowed <= tbb::this_task_arena::max_concurrency()) return run_on_threads(blocks);
  tbb::task_arena wider(allowed);  // a limit above the number of cores asks for it
  wider.execute([&] { run_on_threads(blocks); });
}

int thread_count() { return static_cast<int>(allowed_threads()); }

struct ThreadLimit::Control {
  tbb::global_control most;
};

#else

void parallel_blocks(std::size_t count, std::size_t grain,
                     const std::function<void(IndexRange)>& body) {
  const Blocks blocks{count, grain, body};
  for (std::size_t b = 0; b < blocks.size(); ++b) blocks.run(b);
}

int thread_count() { return 1; }

struct ThreadLimit::Control {
  std::size_t most;
};

#endif

ThreadLimit::ThreadLimit(int threads) {
  if (threads < 1)
    throw InvalidInput("a limit of " + std::to_string(threads) +
                       " threads; allow at least one thread");
#ifdef SUTURE_TBB
  control_.reset(new Control{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                                 static_cast<std::size_t>(threads))});
#else
  control_.reset(new Control{static_cast<std::size_t>(threads)});
#endif
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace suture
