// The sparse field beside what it was given.
#include "kernel/sparse_field.h"

#include <catch2/catch.hpp>

using namespace suture;

TEST_CASE("a sparse field keeps what it is given, in the order it was given") {
  SparseField<int> field;
  for (int i = 0; i < 1000; ++i) field[pack(i * 7919 % 1000, i, 3)] = i;
  REQUIRE(field.size() == 1000);
  for (int i = 0; i < 1000; ++i) {
    CHECK(field.keys()[i] == pack(i * 7919 % 1000, i, 3));
    REQUIRE(field.find(field.keys()[i]) != nullptr);
    CHECK(*field.find(field.keys()[i]) == i);
  }
  CHECK(field.find(pack(0, 0, 4)) == nullptr);
}
