#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "sims/fuzz/draws.h"

using namespace suture;
using namespace suture::sims;

namespace {

const std::vector<std::string> kFour = {"north", "east", "south", "west"};

}  // namespace

TEST_CASE("a draw is decided by its seed and its name, for ever") {
  CHECK(Draws(1).of("tracker.depth").next() == 0xe792e20a2ad4539f);
  CHECK(Draws(1).in("body", 2).of("radius").next() == 0x01794be7a92647ca);
  CHECK(Draws(0xffffffffffffffff).of("").next() == 0x695058899520ca9d);
  CHECK(Draws(1).choice("motion", kFour) == "south");
}

TEST_CASE("draws of other seeds, names, parts and indices are other draws, and no pattern shows") {
  std::set<std::uint64_t> seen;
  std::size_t draws = 0, bits = 0;
  const auto see = [&](Random random) {
    const std::uint64_t x = random.next();
    seen.insert(x);
    ++draws;
    bits += static_cast<std::size_t>(__builtin_popcountll(x));
  };
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    for (const char* name : {"a", "b", "ab", "ba", "tracker.depth", "tracker.origin"}) {
      see(Draws(seed).of(name));
      for (std::uint64_t index = 0; index < 4; ++index) see(Draws(seed).in(name, index).of("a"));
    }
  CHECK(seen.size() == draws);
  CHECK(static_cast<double>(bits) / static_cast<double>(draws) == Approx(32).margin(0.4));
}

TEST_CASE("draws are spread evenly over the seeds") {
  constexpr int kSeeds = 20000;
  double sum = 0;
  int ones = 0, twos[3] = {0, 0, 0};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Draws d(seed);
    sum += d.uniform("x", 2, 4);
    ones += d.once_in("now and then", 8) ? 1 : 0;
    const int n = d.whole("n", 5, 7);
    REQUIRE((n >= 5 && n <= 7));
    ++twos[n - 5];
    const Point p = d.vector("p", 0.5);
    REQUIRE(p.cwiseAbs().maxCoeff() <= 0.5);
  }
  CHECK(sum / kSeeds == Approx(3).margin(0.02));
  CHECK(std::abs(ones - kSeeds / 8) < 250);
  for (const int count : twos) CHECK(std::abs(count - kSeeds / 3) < 350);
}

TEST_CASE("a word more takes its share of a choice, and changes no other seed's word") {
  constexpr int kSeeds = 10000;
  std::vector<std::string> five = kFour;
  five.insert(five.begin() + 2, "up");
  std::map<std::string, int> four_counts, five_counts;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::string before = Draws(seed).choice("way", kFour);
    const std::string after = Draws(seed).choice("way", five);
    if (after != "up") REQUIRE(after == before);
    ++four_counts[before];
    ++five_counts[after];
  }
  for (const auto& [word, count] : four_counts) CHECK(std::abs(count - kSeeds / 4) < 220);
  for (const auto& [word, count] : five_counts) CHECK(std::abs(count - kSeeds / 5) < 200);
  CHECK(five_counts.size() == 5);
}

TEST_CASE("a choice does not depend on the order of the words") {
  std::vector<std::string> turned = kFour;
  std::reverse(turned.begin(), turned.end());
  for (std::uint64_t seed = 1; seed <= 500; ++seed)
    CHECK(Draws(seed).choice("way", kFour) == Draws(seed).choice("way", turned));
}

TEST_CASE("a word that stands twice is chosen twice as often") {
  constexpr int kSeeds = 10000;
  int north = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    north += Draws(seed).choice("way", {"north", "east", "south", "north"}) == "north" ? 1 : 0;
  CHECK(std::abs(north - kSeeds / 2) < 250);
}
