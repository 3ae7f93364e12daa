// A portable seeded generator, and what is drawn with it: the same on every machine and library.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/hash.h"

namespace suture {

/// SplitMix64 [Steele, Lea and Flood 2014]. Any seed will do, zero too.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() { return spread(state_ += kGoldenStep); }

  /// Uniform in [0, 1), a multiple of 2⁻⁵³.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform in 0 … count − 1 (biased by less than count·2⁻⁶⁴). \pre count > 0
  std::uint64_t below(std::uint64_t count) { return next() % count; }

 private:
  std::uint64_t state_;
};

/// Puts the items into an order in which each is equally likely [Fisher and Yates; Durstenfeld
/// 1964].
template <class T>
void shuffle(std::vector<T>& items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
}

}  // namespace suture
