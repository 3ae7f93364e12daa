// Edges of an indexed surface, found through the buckets of their lower vertex.
#include "kernel/incidence.h"

#include <algorithm>
#include <string>

#include "kernel/errors.h"

namespace suture {

Incidence incidence(const Triangles& surface) {
  Incidence result;
  result.positions = surface.positions;
  result.triangles = surface.triangles;
  result.triangle_edges.resize(surface.triangles.size());
  result.edges.reserve(surface.triangles.size() * 3 / 2);
  result.edge_triangles.reserve(surface.triangles.size() * 3 / 2);
  // A vertex has half as many edges of which it is the lower end as it has edges: short lists.
  std::vector<std::uint32_t> first(surface.positions.size(), kNone), next;
  next.reserve(surface.triangles.size() * 3 / 2);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax(surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]);
      std::uint32_t e = first[low];
      while (e != kNone && result.edges[e][1] != high) e = next[e];
      if (e == kNone) {
        e = static_cast<std::uint32_t>(result.edges.size());
        result.edges.push_back({low, high});
        result.edge_triangles.push_back({t, kNone});
        next.push_back(first[low]);
        first[low] = e;
      } else if (result.edge_triangles[e][1] == kNone) {
        result.edge_triangles[e][1] = t;
      } else {
        throw InternalFailure("incidence", "edge " + std::to_string(low) + "-" +
                                               std::to_string(high) + " has a third triangle");
      }
      result.triangle_edges[t][k] = e;
    }
  }
  for (const auto& [a, b] : result.edge_triangles)
    if (b == kNone)
      throw InternalFailure("incidence", "triangle " + std::to_string(a) + " has an open edge");
  return result;
}

}  // namespace suture
