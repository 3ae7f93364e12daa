// The winding of the difference of two surfaces is the change of winding: cost follows the surgery.
#include "surgery/detect/invariance.h"

namespace suture::surgery {

namespace {

bool same(const Triangle& before, const Triangle& after,
          const std::vector<std::uint32_t>& vertex_map) {
  const Triangle moved = {vertex_map[before[0]], vertex_map[before[1]], vertex_map[before[2]]};
  for (std::size_t r = 0; r < 3; ++r)
    if (after == Triangle{moved[r], moved[(r + 1) % 3], moved[(r + 2) % 3]}) return true;
  return false;
}

}  // namespace

Triangles difference(const Triangles& before, const Triangles& after, const Lineage& lineage) {
  const auto& [kept, vertex_map] = lineage;
  // Vertices of `after` come first, then those of `before` that went; each only where a triangle
  // needs it.
  Triangles result;
  std::vector<std::uint32_t> of_after(after.positions.size(), kNone);
  std::vector<std::uint32_t> of_before(before.positions.size(), kNone);
  auto number = [&](std::uint32_t& known, const Point& position) {
    if (known == kNone) {
      known = static_cast<std::uint32_t>(result.positions.size());
      result.positions.push_back(position);
    }
    return known;
  };
  std::vector<char> stays(before.triangles.size(), 0);
  for (std::size_t t = 0; t < after.triangles.size(); ++t) {
    const Triangle& v = after.triangles[t];
    if (kept[t] != kNone && same(before.triangles[kept[t]], v, vertex_map)) {
      stays[kept[t]] = 1;
      continue;
    }
    auto& added = result.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) added[k] = number(of_after[v[k]], after.positions[v[k]]);
  }
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    if (stays[t] != 0) continue;
    Triangle taken;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = before.triangles[t][k], survivor = vertex_map[v];
      taken[k] = survivor == kNone ? number(of_before[v], before.positions[v])
                                   : number(of_after[survivor], after.positions[survivor]);
    }
    result.triangles.push_back({taken[0], taken[2], taken[1]});
  }
  return result;
}

std::vector<Index3> wrongly_changed(const Triangles& difference, const Detected& before) {
  constexpr int kAxis = 2;
  const Winding change(
      find_crossings(incidence(difference, EdgeUse::any), before.on, Lines::along_z));
  std::vector<Index3> nodes;
  const auto& edges = change.edges(kAxis);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (edges[i].after == 0) continue;  // else the line goes on to the next edge
    Index3 node = unpack(edges[i].edge);
    for (const int last = unpack(edges[i + 1].edge)[kAxis]; node[kAxis] < last;) {
      ++node[kAxis];
      const int was = before.winding.at(node), is = was + edges[i].after;
      const bool fine = (was > 1 && is >= 1) || (was < 0 && is < 1);
      if (!fine) nodes.push_back(node);
    }
  }
  return nodes;
}

}  // namespace suture::surgery
