// Union–find beside labels that are all written anew at each joining.
#include "kernel/union_find.h"

#include <catch2/catch.hpp>

#include "kernel/random.h"

using namespace suture;

TEST_CASE("union–find joins the sets that writing labels anew joins, and its root is the lowest") {
  Random random(3);
  constexpr std::uint32_t kCount = 200;
  UnionFind sets(kCount);
  std::vector<std::uint32_t> label = identity_map(kCount);  // the lowest member of each one's set
  std::size_t joined = 0;
  for (int n = 0; n < 300; ++n) {
    const auto a = static_cast<std::uint32_t>(random.below(kCount));
    const auto b = static_cast<std::uint32_t>(random.below(kCount));
    const std::uint32_t low = std::min(label[a], label[b]), high = std::max(label[a], label[b]);
    const bool apart = low != high;
    REQUIRE(sets.join(a, b) == apart);
    joined += apart ? 1 : 0;
    for (std::uint32_t& l : label)
      if (l == high) l = low;
    for (std::uint32_t x = 0; x < kCount; ++x) REQUIRE(sets.root(x) == label[x]);
  }
  CHECK(joined > kCount / 2);
}

TEST_CASE("a set joined to another takes its root, whichever is lower") {
  UnionFind sets(5);
  CHECK(sets.join_to(0, 3) == 3);
  CHECK(sets.join_to(3, 1) == 1);
  CHECK(sets.root(0) == 1);
  CHECK(sets.join_to(0, 1) == 1);
  CHECK(sets.root(4) == 4);
}

TEST_CASE("members that are separated again are sets of their own") {
  UnionFind sets(4);
  sets.join(0, 1);
  sets.join(2, 1);
  for (const std::uint32_t x : {0U, 1U, 2U}) sets.separate(x);
  for (const std::uint32_t x : {0U, 1U, 2U, 3U}) CHECK(sets.root(x) == x);
  CHECK(sets.join(2, 3));
  CHECK(sets.root(3) == 2);
}
