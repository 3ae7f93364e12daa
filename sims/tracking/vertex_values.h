// Values at vertices, carried over a surgery or an improvement that changed the vertices.
#pragma once

#include "kernel/triangles.h"

namespace suture::sims {

/// Values at the new surface's vertices: the mean of the old vertices that `vertex_map` sends
/// there; for a new vertex the mean of its neighbours that have one, from known ones outwards, or
/// `zero` where a whole component is new. An empty map, with the counts equal: nothing changed.
template <class T>
std::vector<T> carried(const std::vector<T>& values, const T& zero, const Triangles& surface,
                       const std::vector<std::uint32_t>& vertex_map) {
  const std::size_t n = surface.positions.size();
  if (vertex_map.empty() && values.size() == n) return values;
  std::vector<T> sum(n, zero);
  std::vector<double> count(n, 0.0);
  for (std::size_t old = 0; old < vertex_map.size() && old < values.size(); ++old) {
    const std::uint32_t v = vertex_map[old];
    if (v == kNone) continue;
    sum[v] = sum[v] + values[old];
    count[v] += 1;
  }
  std::vector<char> known(n, 0);
  for (bool more = true; more;) {
    more = false;
    for (std::size_t v = 0; v < n; ++v) {
      if (known[v] != 0 || count[v] == 0) continue;
      sum[v] = sum[v] * (1 / count[v]);
      known[v] = 1;
      more = true;
    }
    if (!more) break;
    for (const Triangle& t : surface.triangles)
      for (int i = 0; i < 3; ++i)
        for (const std::uint32_t other : {t[(i + 1) % 3], t[(i + 2) % 3]})
          if (known[t[i]] == 0 && known[other] != 0) {
            sum[t[i]] = sum[t[i]] + sum[other];
            count[t[i]] += 1;
          }
  }
  return sum;
}

}  // namespace suture::sims
