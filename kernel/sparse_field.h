// A map from lattice ids to values: open addressing, iterated in the order of insertion.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/hash.h"
#include "kernel/lattice.h"

namespace suture {

/// Values at a sparse set of lattice ids; costs what it holds, not what the lattice could hold.
/// Iteration order is the order of insertion, so results do not depend on hashing.
template <class T>
class SparseField {
 public:
  std::size_t size() const { return keys_.size(); }
  bool empty() const { return keys_.empty(); }
  const std::vector<LatticeId>& keys() const { return keys_; }
  const std::vector<T>& values() const { return values_; }
  std::vector<T>& values() { return values_; }

  /// The value at `id`, or null.
  const T* find(LatticeId id) const {
    if (slots_.empty()) return nullptr;
    const std::uint32_t at = slots_[slot(id)];
    return at == kNone ? nullptr : &values_[at];
  }
  T* find(LatticeId id) { return const_cast<T*>(static_cast<const SparseField*>(this)->find(id)); }
  bool contains(LatticeId id) const { return find(id) != nullptr; }

  /// The value at `id`, made from `T{}` if there is none yet.
  T& operator[](LatticeId id) { return values_[index(id)]; }

  /// Position of `id` in keys() and values(), added at the end if it is new.
  std::size_t index(LatticeId id) {
    if (2 * (keys_.size() + 1) > slots_.size()) grow();
    const std::size_t s = slot(id);
    if (slots_[s] == kNone) {
      slots_[s] = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(id);
      values_.emplace_back();
    }
    return slots_[s];
  }

 private:
  std::size_t slot(LatticeId id) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t s = static_cast<std::size_t>(mixed(0, id)) & mask;
    while (slots_[s] != kNone && keys_[slots_[s]] != id) s = (s + 1) & mask;
    return s;
  }
  void grow() {
    slots_.assign(slots_.empty() ? 16 : 2 * slots_.size(), kNone);
    for (std::size_t i = 0; i < keys_.size(); ++i)
      slots_[slot(keys_[i])] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> slots_;
  std::vector<LatticeId> keys_;
  std::vector<T> values_;
};

}  // namespace suture
