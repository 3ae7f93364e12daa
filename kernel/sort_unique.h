// A list as a set: sorted, each once.
#pragma once

#include <algorithm>
#include <vector>

namespace suture {

/// Sorts the items, and keeps one of those that are equal.
template <class T>
void sort_unique(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace suture
