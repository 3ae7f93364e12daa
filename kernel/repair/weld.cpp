// Open addressing over the bits of the coordinates; only ever asked, never iterated.
#include "kernel/repair/weld.h"

#include <bit>

#include "kernel/hash.h"

namespace suture {

namespace {

std::uint64_t hash(const Point& p) {
  std::uint64_t h = 0;
  for (const double x : p) {
    const double merged = x == 0 ? 0.0 : x;  // one hash for both zeros
    h = mixed(h, std::bit_cast<std::uint64_t>(merged));
  }
  return h;
}

}  // namespace

std::vector<std::uint32_t> first_equal(const std::vector<Point>& points) {
  std::vector<std::uint32_t> first(points.size());
  const std::size_t slots = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::uint32_t> table(slots, kNone);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t s = static_cast<std::size_t>(hash(points[i])) & (slots - 1);
    while (table[s] != kNone && points[table[s]] != points[i]) s = (s + 1) & (slots - 1);
    if (table[s] == kNone) table[s] = static_cast<std::uint32_t>(i);
    first[i] = table[s];
  }
  return first;
}

}  // namespace suture
