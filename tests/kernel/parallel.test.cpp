// Loops and sums on threads: the same bits, exceptions and floating-point mode as in order.
#include "kernel/parallel.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <bit>
#include <cfenv>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "kernel/errors.h"
#include "kernel/random.h"

using namespace suture;

namespace {

/// Terms of many sizes, so that a sum in another order has other bits.
std::vector<double> terms(std::size_t count) {
  Random random(7);
  std::vector<double> all(count);
  for (double& x : all)
    x = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(40)) - 20);
  return all;
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

/// The sum as parallel_sum documents it, by plain loops.
double sum_by_blocks(const std::vector<double>& x) {
  double total = 0;
  for (std::size_t begin = 0; begin < x.size(); begin += kTermsABlock) {
    double sum = 0;
    for (std::size_t i = begin; i < std::min(x.size(), begin + kTermsABlock); ++i) sum += x[i];
    total += sum;
  }
  return total;
}

constexpr int kThreads[] = {1, 2, 8};

}  // namespace

TEST_CASE("each index is visited once, whatever the grain and the number of threads") {
  for (const int threads : kThreads) {
    const ThreadLimit limit(threads);
    for (const std::size_t count : {0U, 1U, 2U, 1000U, 4097U})
      for (const std::size_t grain : {1U, 3U, 1000U, 100000U}) {
        std::vector<int> visits(count, 0);
        parallel_for(
            count, [&](std::size_t i) { ++visits[i]; }, grain);
        CHECK(visits == std::vector<int>(count, 1));
      }
  }
}

TEST_CASE("the blocks of a loop are the same at any number of threads") {
  for (const int threads : kThreads) {
    const ThreadLimit limit(threads);
    std::vector<std::size_t> ends(4, 0);
    parallel_blocks(10, 3, [&](IndexRange range) { ends[range.begin / 3] = range.end; });
    CHECK(ends == std::vector<std::size_t>{3, 6, 9, 10});
  }
}

TEST_CASE("a sum on 1, 2 and 8 threads has the same bits, those of its blocks in order") {
  for (const std::size_t count : {1U, 1000U, 1024U, 1025U, 100003U}) {
    const std::vector<double> x = terms(count);
    const std::uint64_t expected = bits(sum_by_blocks(x));
    for (const int threads : kThreads) {
      const ThreadLimit limit(threads);
      for (int repeat = 0; repeat < 5; ++repeat)
        CHECK(bits(parallel_sum(count, [&](std::size_t i) { return x[i]; })) == expected);
    }
  }
  const std::vector<double> x = terms(100003);
  CHECK(bits(std::accumulate(x.rbegin(), x.rend(), 0.0)) != bits(sum_by_blocks(x)));
}

TEST_CASE("a sum of one block has the bits of a plain loop") {
  const std::vector<double> x = terms(kTermsABlock);
  CHECK(bits(parallel_sum(x.size(), [&](std::size_t i) { return x[i]; })) ==
        bits(std::accumulate(x.begin(), x.end(), 0.0)));
  CHECK(parallel_sum(0, [](std::size_t) { return 1.0; }) == 0);
}

TEST_CASE("a maximum skips NaN and starts from the least value given") {
  std::vector<double> x = terms(5000);
  x[17] = std::numeric_limits<double>::quiet_NaN();
  x[4001] = 1e9;
  for (const int threads : kThreads) {
    const ThreadLimit limit(threads);
    CHECK(parallel_max(x.size(), 0, [&](std::size_t i) { return x[i]; }) == 1e9);
    CHECK(parallel_max(
              x.size(), 0, [&](std::size_t i) { return x[i]; }, 1) == 1e9);
    CHECK(parallel_max(x.size(), 2e9, [&](std::size_t i) { return x[i]; }) == 2e9);
  }
  CHECK(parallel_max(0, -3, [](std::size_t) { return 1.0; }) == -3);
}

TEST_CASE("of several exceptions the caller gets that of the lowest index, every time") {
  for (const int threads : kThreads) {
    const ThreadLimit limit(threads);
    for (int repeat = 0; repeat < 50; ++repeat) {
      std::atomic<int> below = 0;
      const auto body = [&](std::size_t i) {
        if (i < 321) ++below;
        if (i % 321 == 0 && i > 0) throw std::runtime_error(std::to_string(i));
      };
      CHECK_THROWS_WITH(parallel_for(2000, body), Catch::Equals("321"));
      CHECK(below == 321);
    }
  }
}

TEST_CASE("loops may be nested, and an inner exception reaches the outer caller") {
  for (const int threads : kThreads) {
    const ThreadLimit limit(threads);
    std::vector<double> sums(37);
    parallel_for(sums.size(), [&](std::size_t i) {
      sums[i] =
          parallel_sum(5000, [&](std::size_t j) { return 1.0 / static_cast<double>(i + j + 1); });
    });
    for (std::size_t i = 0; i < sums.size(); ++i)
      CHECK(bits(sums[i]) == bits(parallel_sum(5000, [&](std::size_t j) {
              return 1.0 / static_cast<double>(i + j + 1);
            })));
    CHECK_THROWS_WITH(parallel_for(20,
                                   [](std::size_t i) {
                                     parallel_for(20, [&](std::size_t j) {
                                       if (i >= 3 && j == 5) throw InvalidInput(std::to_string(i));
                                     });
                                   }),
                      Catch::Equals("3"));
  }
}

TEST_CASE("bodies see the caller's rounding mode on every thread, and leave none behind") {
  for (const int threads : kThreads) {
    const ThreadLimit limit(threads);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TONEAREST}) {
      REQUIRE(std::fesetround(mode) == 0);
      std::vector<int> seen(500, -1);
      parallel_for(seen.size(), [&](std::size_t i) { seen[i] = std::fegetround(); });
      const int after = std::fegetround();
      REQUIRE(std::fesetround(FE_TONEAREST) == 0);
      CHECK(seen == std::vector<int>(500, mode));
      CHECK(after == mode);
    }
  }
}

TEST_CASE("subnormals survive on every thread") {
  const volatile double least = std::numeric_limits<double>::denorm_min();
  const ThreadLimit limit(8);
  std::vector<double> half(500);
  parallel_for(half.size(), [&](std::size_t i) { half[i] = 3 * least; });
  CHECK(half == std::vector<double>(500, 3 * std::numeric_limits<double>::denorm_min()));
}

TEST_CASE("the least of several thread limits counts, until it ends") {
  const int before = thread_count();
  {
    const ThreadLimit outer(2);
    const ThreadLimit inner(1);
    CHECK(thread_count() == 1);
  }
  CHECK(thread_count() == before);
  CHECK_THROWS_AS(ThreadLimit(0), InvalidInput);
}
