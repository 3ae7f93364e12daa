// The generator beside the published numbers, and what is drawn with it.
#include "kernel/random.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include "kernel/lists.h"

using namespace suture;

TEST_CASE("the generator gives the numbers that SplitMix64 gives from the seed 1234567") {
  Random random(1234567);
  CHECK(random.next() == 6457827717110365317ULL);
  CHECK(random.next() == 3203168211198807973ULL);
  CHECK(random.next() == 9817491932198370423ULL);
}

TEST_CASE("each order of three items comes about equally often from a shuffle") {
  Random random(5);
  std::map<std::vector<int>, int> times;
  for (int n = 0; n < 6000; ++n) {
    std::vector<int> items{1, 2, 3};
    shuffle(items, random);
    ++times[items];
  }
  REQUIRE(times.size() == 6);
  for (const auto& [order, n] : times) CHECK(n == Approx(1000).margin(120));
}

TEST_CASE("a shuffle keeps every item and repeats itself from the same seed") {
  std::vector<std::uint32_t> one = identity_map(100), other = identity_map(100);
  Random first(11), second(11);
  shuffle(one, first);
  shuffle(other, second);
  CHECK(one == other);
  CHECK(one != identity_map(100));
  std::sort(one.begin(), one.end());
  CHECK(one == identity_map(100));
}
