// Union–find: disjoint sets of indices that can be joined, each known by one member, its root.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernel/lists.h"

namespace suture {

/// Sets of the indices 0 … count − 1, each index a set of its own at first. Paths are halved as
/// they are walked [Tarjan and van Leeuwen 1984]; sets are not balanced, so that the root is the
/// caller's choice and does not depend on sizes.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(identity_map(count)) {}

  std::size_t size() const { return parent_.size(); }

  /// The member that stands for the set of x. \pre x < size()
  std::uint32_t root(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }

  /// Joins the sets of a and b; the lower of their roots stays, so that the root of a set that was
  /// only joined so is its lowest member. Returns whether they were two sets.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  /// Joins the set of a to that of b, whose root stays. Returns that root.
  std::uint32_t join_to(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    return parent_[a] = b;
  }

  /// Makes x a set of its own again. \pre no member of its set is asked for or joined before it is
  /// separated too
  void separate(std::uint32_t x) { parent_[x] = x; }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace suture
