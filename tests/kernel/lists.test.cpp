// Lists as sets, as maps that change nothing, and their middles.
#include "kernel/lists.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace suture;

TEST_CASE("a list as a set is sorted and holds each item once") {
  std::vector<int> items{3, 1, 2, 3, 1};
  sort_unique(items);
  CHECK(items == std::vector<int>{1, 2, 3});
}

TEST_CASE("an identity map holds its own indices") {
  CHECK(identity_map(3) == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(identity_map<std::size_t>(0).empty());
}

TEST_CASE("a median is the middle value, or the mean of the two middle ones") {
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  CHECK(median({7}) == 7);
  CHECK(std::isnan(median({})));
}
