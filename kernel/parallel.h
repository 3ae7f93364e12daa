// One seam for threads: loops and sums whose bits do not depend on how many threads there are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace suture {

/// The indices begin … end − 1.
struct IndexRange {
  std::size_t begin, end;
};

/// Calls body(range) once for each block of `grain` indices of 0 … count − 1, the last block may be
/// shorter; the blocks are the same at any number of threads, their order is not. Bodies may run at
/// once and may call this again; each sees the caller's rounding mode and treatment of subnormals.
/// The library's threads are oneTBB's; built without it, the caller runs the blocks in order.
/// \pre grain > 0, and no body writes what another reads or writes
/// \throw what a body throws: of several, that of the lowest block, as if they ran in order
void parallel_blocks(std::size_t count, std::size_t grain,
                     const std::function<void(IndexRange)>& body);

/// Calls f(i) once for each i of 0 … count − 1, `grain` neighbours at a time on one thread.
/// \pre, \throw as parallel_blocks
template <class F>
void parallel_for(std::size_t count, F f, std::size_t grain = 1) {
  parallel_blocks(count, grain, [&](IndexRange range) {
    for (std::size_t i = range.begin; i < range.end; ++i) f(i);
  });
}

/// So many terms of a parallel sum or maximum are taken on one thread, in order.
inline constexpr std::size_t kTermsABlock = 1024;

/// The sum of f(i) over 0 … count − 1: each block of kTermsABlock terms is summed from the lowest
/// index up, and then the blocks' sums are, so that the bits are the same at any number of threads.
/// A sum of one block has the bits of a plain loop. \pre, \throw as parallel_blocks
template <class F>
double parallel_sum(std::size_t count, F f) {
  std::vector<double> sums((count + kTermsABlock - 1) / kTermsABlock, 0.0);
  parallel_blocks(count, kTermsABlock, [&](IndexRange range) {
    double sum = 0;
    for (std::size_t i = range.begin; i < range.end; ++i) sum += f(i);
    sums[range.begin / kTermsABlock] = sum;
  });
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

/// The largest of `least` and all f(i) over 0 … count − 1; NaN is skipped. `grain` terms are taken
/// on one thread. \pre, \throw as parallel_blocks
template <class F>
double parallel_max(std::size_t count, double least, F f, std::size_t grain = kTermsABlock) {
  std::vector<double> largest((count + grain - 1) / grain, least);
  parallel_blocks(count, grain, [&](IndexRange range) {
    double& most = largest[range.begin / grain];
    for (std::size_t i = range.begin; i < range.end; ++i) most = std::max(most, f(i));
  });
  for (const double most : largest) least = std::max(least, most);
  return least;
}

/// How many threads a loop started here may use; 1 without oneTBB.
int thread_count();

/// While it lives, loops of this process use at most so many threads, those that other libraries
/// start through oneTBB too; more than there are cores is allowed. The least of several counts.
class ThreadLimit {
 public:
  /// \throw InvalidInput if threads < 1
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace suture
