// Components are compared as sets of coordinate triangles, by a sum of hashes first and exactly
// then.
#include "surgery/operate/coincident.h"

#include <algorithm>
#include <bit>
#include <map>

#include "kernel/hash.h"
#include "surgery/detect/winding.h"

namespace suture::surgery {

namespace {

using Coordinates = std::array<double, 9>;

/// The triangle's coordinates from the corner that makes them least, so that numbering does not
/// matter; corners may share a place.
Coordinates canonical(const Triangles& surface, const Triangle& t) {
  Coordinates least;
  for (std::size_t from = 0; from < 3; ++from) {
    Coordinates c;
    for (std::size_t i = 0; i < 9; ++i)
      c[i] = surface.positions[t[(from + i / 3) % 3]][static_cast<Eigen::Index>(i % 3)] +
             0.0;  // −0 is 0
    if (from == 0 || c < least) least = c;
  }
  return least;
}

std::uint64_t hash(const Coordinates& c) {
  std::uint64_t h = kGoldenStep;
  for (const double x : c) h = mixed(h, std::bit_cast<std::uint64_t>(x));
  return h;
}

using Members = std::vector<std::vector<std::uint32_t>>;

std::vector<Coordinates> sorted(const Triangles& surface,
                                const std::vector<std::uint32_t>& members) {
  std::vector<Coordinates> all;
  for (const std::uint32_t t : members) all.push_back(canonical(surface, surface.triangles[t]));
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

std::vector<std::uint32_t> repeated_triangles(const Triangles& surface,
                                              const Components& components) {
  Members members(components.count);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    members[components.of_triangle[t]].push_back(t);
  std::map<std::size_t, std::vector<std::size_t>> by_size;
  for (std::size_t c = 0; c < members.size(); ++c) by_size[members[c].size()].push_back(c);

  std::vector<std::uint32_t> repeated;
  for (const auto& [size, alike] : by_size) {
    if (alike.size() < 2) continue;
    std::map<std::uint64_t, std::vector<std::size_t>> firsts;
    for (const std::size_t c : alike) {
      std::uint64_t sum = 0;
      for (const std::uint32_t t : members[c])
        sum += hash(canonical(surface, surface.triangles[t]));
      auto& candidates = firsts[sum];
      const bool known = std::any_of(candidates.begin(), candidates.end(), [&](std::size_t first) {
        return sorted(surface, members[first]) == sorted(surface, members[c]);
      });
      if (known)
        repeated.insert(repeated.end(), members[c].begin(), members[c].end());
      else
        candidates.push_back(c);
    }
  }
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

bool sides_agree(const Triangles& single, const Triangles& repeated, const Lattice& lattice,
                 const Oracle& oracle) {
  constexpr int kAxis = 2;
  auto scan = [&](const Triangles& surface) {
    return Winding(find_crossings(incidence(surface), lattice, oracle, Lines::along_z));
  };
  const Winding one = scan(single), rest = scan(repeated);
  // Along a line both windings change at crossed edges only, so the ends of these see every value.
  for (const Winding* crossed : {&one, &rest})
    for (const CrossedEdge& e : crossed->edges(kAxis))
      for (const LatticeId id : {e.edge, step(e.edge, kAxis, 1)}) {
        const Index3 node = unpack(id);
        const int w = one.at(node);
        if ((w >= 1) != (w + rest.at(node) >= 1)) return false;
      }
  return true;
}

}  // namespace suture::surgery
