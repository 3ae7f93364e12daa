// Small things asked of any list: as a set, as a map that changes nothing, and its middle.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace suture {

/// Sorts the items, and keeps one of those that are equal.
template <class T>
void sort_unique(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// The list 0 … count − 1: as a map from indices to indices it changes nothing.
template <class Index = std::uint32_t>
std::vector<Index> identity_map(std::size_t count) {
  std::vector<Index> map(count);
  std::iota(map.begin(), map.end(), Index{0});
  return map;
}

/// The middle value, or the mean of the two middle ones; NaN for an empty list. \pre no NaN in it
inline double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

}  // namespace suture
