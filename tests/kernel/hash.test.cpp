// Hashes beside the values that their authors publish.
#include "kernel/hash.h"

#include <catch2/catch.hpp>

#include <set>

using namespace suture;

TEST_CASE("FNV-1a gives the published values") {
  CHECK(fnv1a("") == 0xcbf29ce484222325ULL);
  CHECK(fnv1a("a") == 0xaf63dc4c8601ec8cULL);
  CHECK(fnv1a("foobar") == 0x85944171f73967e8ULL);
  CHECK(fnv1a("bar", fnv1a("foo")) == fnv1a("foobar"));
}

TEST_CASE("FNV-1a of a word is that of its bytes from the lowest up") {
  CHECK(fnv1a(0x6867666564636261ULL, kFnvStart) == fnv1a("abcdefgh"));
  const std::string_view high("\xff\x80\x00\x00\x00\x00\x00\x7f", 8);
  CHECK(fnv1a(0x7f000000000080ffULL, kFnvStart) == fnv1a(high));
}

TEST_CASE("spreading is one-to-one on small numbers and changes about half of the bits") {
  std::set<std::uint64_t> values;
  int changed = 0;
  for (std::uint64_t x = 0; x < 10000; ++x) {
    values.insert(spread(x));
    changed += __builtin_popcountll(spread(x) ^ spread(x + 1));
  }
  CHECK(values.size() == 10000);
  CHECK(changed / 10000.0 == Approx(32).margin(0.5));
}

TEST_CASE("mixing depends on the order of the words") {
  CHECK(mixed(mixed(0, 1), 2) != mixed(mixed(0, 2), 1));
  CHECK(mixed(0, 1) == (0xff51afd7ed558ccdULL ^ 0xff51afd7ULL));
}
