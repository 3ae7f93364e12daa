// Zones are united from runs of nodes along lattice lines, so the cost follows the surface.
#include "surgery/detect/zones.h"

#include <algorithm>
#include <numeric>

namespace suture::surgery {

namespace {

constexpr int kAxis = 2;  // lines along z: their edges are sorted by id

bool in_zone(int winding) { return winding < 0 || winding > 1; }

bool same_line(LatticeId a, LatticeId b) {
  const Index3 p = unpack(a), q = unpack(b);
  return p[0] == q[0] && p[1] == q[1];
}

/// Whether a node has a winding that the events leave as it is.
bool any_left(const Winding& winding, Events events) {
  const auto& edges = winding.edges(kAxis);
  return std::any_of(edges.begin(), edges.end(), [&](const CrossedEdge& e) {
    return (e.after < 0 && !splits(events)) || (e.after > 1 && !merges(events));
  });
}

template <class Visit>
void for_each_corner(LatticeId cell, Visit visit) {
  for (int corner = 0; corner < 8; ++corner)
    visit(step(step(step(cell, 0, corner & 1), 1, corner >> 1 & 1), 2, corner >> 2));
}

/// Run i holds the nodes from the upper end of crossed edge i to the lower end of the next one.
class Zones {
 public:
  explicit Zones(const Winding& winding)
      : edges_(winding.edges(kAxis)), parent_(winding.edges(kAxis).size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
      if (!in_zone(edges_[i].after)) continue;
      if (in_zone(edges_[i + 1].after)) unite(i, i + 1);  // a line ends outside, so it is the same
      for (int across = 0; across < kAxis; ++across) unite_with_line_beyond(i, across);
    }
  }

  /// The zone of a node, the same number for all its nodes, or edges().size() if it has none.
  std::size_t of(LatticeId node) {
    const std::size_t next = first_from(node);
    if (next == 0 || !same_line(edges_[next - 1].edge, node) || !in_zone(edges_[next - 1].after))
      return none();
    return root(next - 1);
  }
  std::size_t none() const { return edges_.size(); }

 private:
  /// The first crossed edge whose lower end is `node`, or comes after it.
  std::size_t first_from(LatticeId node) const {
    return static_cast<std::size_t>(
        std::lower_bound(edges_.begin(), edges_.end(), node,
                         [](const CrossedEdge& e, LatticeId id) { return e.edge < id; }) -
        edges_.begin());
  }

  void unite_with_line_beyond(std::size_t run, int across) {
    const LatticeId low = step(step(edges_[run].edge, kAxis, 1), across, 1);
    const LatticeId high = step(edges_[run + 1].edge, across, 1);
    std::size_t other = first_from(low);
    if (other > 0 && same_line(edges_[other - 1].edge, low)) --other;
    for (; other < edges_.size() && edges_[other].edge < high; ++other)
      if (in_zone(edges_[other].after)) unite(run, other);
  }

  std::size_t root(std::size_t run) {
    while (parent_[run] != run) run = parent_[run] = parent_[parent_[run]];
    return run;
  }
  void unite(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

  const std::vector<CrossedEdge>& edges_;
  std::vector<std::size_t> parent_;
};

/// A cell that holds mesh, and a zone in which it has a corner.
using ZoneCell = std::pair<std::size_t, LatticeId>;

std::vector<ZoneCell> cells_of_zones(const CellSet& set, Zones& zones) {
  std::vector<ZoneCell> found;
  for (const LatticeId cell : set.cells.keys())
    for_each_corner(cell, [&](LatticeId node) {
      if (const std::size_t zone = zones.of(node); zone != zones.none())
        found.emplace_back(zone, cell);
    });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

Region grow_over_zones(Region region, const Ground& in) {
  if (region.empty() || !any_left(in.winding, in.events)) return region;
  Zones zones(in.winding);
  const std::vector<ZoneCell> cells = cells_of_zones(in.cells, zones);
  std::vector<char> taken(zones.none() + 1, 0);
  taken.back() = 1;  // nodes without a zone
  for (std::size_t next = 0; next < region.cells.size();) {
    std::vector<LatticeId> seeds = region.cells.keys();
    const std::size_t before = seeds.size();
    for (; next < before; ++next)
      for_each_corner(seeds[next], [&](LatticeId node) {
        const std::size_t zone = zones.of(node);
        if (taken[zone] != 0) return;
        taken[zone] = 1;
        for (auto c = std::lower_bound(cells.begin(), cells.end(), ZoneCell{zone, 0});
             c != cells.end() && c->first == zone; ++c)
          seeds.push_back(c->second);
      });
    if (seeds.size() > before) region = grow_region(seeds, in.cells);
  }
  return region;
}

}  // namespace suture::surgery
