// Merging walks from side to side through unmarked neighbours, so touching loops never get
// confused.
#include "surgery/operate/kept_pieces.h"

#include <algorithm>
#include <map>

#include "kernel/errors.h"
#include "kernel/union_find.h"

namespace suture::surgery {

namespace {

/// The region cells at a site of a triangle, at most four.
struct NearCells {
  std::array<LatticeId, 4> cells{};
  int count = 0;
  void see(LatticeId cell, const Region& region) {
    if (region.holds(cell)) cells[count++] = cell;
  }
};

NearCells near_cells(const TrianglePieces& pieces, std::uint32_t site, const CutInput& in) {
  NearCells near;
  if (pieces.is_corner(site)) return near;
  if (pieces.is_edge_site(site)) {
    const FaceStep& face = in.crossings.edge_crossings[pieces.edge_site(site).crossing];
    near.see(face.face, in.region);
    near.see(step(face.face, face.axis, -1), in.region);
    return near;
  }
  const auto& line = pieces.line_site(site);
  cells_round_edge(line.edge, line.axis, [&](LatticeId cell) { near.see(cell, in.region); });
  return near;
}

/// Bit k: the site is on the triangle's edge k.
int edges_at(const TrianglePieces& pieces, std::uint32_t site) {
  if (pieces.is_corner(site)) return 1 << site | 1 << (site + 2) % 3;
  return pieces.is_edge_site(site) ? 1 << pieces.edge_site(site).mesh_edge : 0;
}

}  // namespace

KeptPieces::KeptPieces(const CutInput& input, std::uint32_t triangle, const TrianglePieces& pieces,
                       Sites& sites, Part part)
    : in_(input),
      triangle_(triangle),
      pieces_(pieces),
      sites_(sites),
      part_(part),
      global_(3 + pieces.edge_sites.size() + pieces.line_sites.size(), kNone) {}

void KeptPieces::avoid(const std::vector<Triangle>& outside) {
  for (const Triangle& t : outside)
    for (std::size_t k = 0; k < 3; ++k) taken_.insert(std::minmax(t[k], t[(k + 1) % 3]));
}

std::uint32_t KeptPieces::global(std::uint32_t local) {
  std::uint32_t& id = global_[local];
  if (id != kNone) return id;
  if (pieces_.is_corner(local)) {
    id = sites_.corner(in_.mesh.triangles[triangle_][local]);
  } else if (pieces_.is_edge_site(local)) {
    const auto& e = pieces_.edge_site(local);
    id = sites_.type2(e.crossing, in_.mesh.triangle_edges[triangle_][e.mesh_edge]);
  } else {
    const auto& line = pieces_.line_site(local);
    id = sites_.type1(line.axis, line.edge, triangle_);
  }
  return id;
}

std::vector<Arc> KeptPieces::arcs() {
  std::vector<Arc> arcs;
  for (const PieceSide& s : pieces_.sides) {
    if (!kept(s) || s.neighbour == kNoCell || !in_.region.holds(s.neighbour)) continue;
    int face = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (step(s.neighbour, axis, 1) == s.cell) face = 2 * axis + 1;
      if (step(s.neighbour, axis, -1) == s.cell) face = 2 * axis;
    }
    arcs.push_back({s.neighbour, face, global(s.to), global(s.from)});
  }
  return arcs;
}

std::uint32_t KeptPieces::next_on_boundary(std::uint32_t side) const {
  std::uint32_t n = pieces_.sides[side].next;
  while (!on_boundary(pieces_.sides[n])) n = pieces_.sides[pieces_.sides[n].twin].next;
  return n;
}

std::vector<std::uint32_t> KeptPieces::loop_from(std::uint32_t first,
                                                 const std::vector<char>& inserted,
                                                 std::vector<char>& seen) const {
  std::vector<std::uint32_t> loop;
  std::uint32_t s = first;
  do {
    seen[s] = 1;
    const std::uint32_t n = next_on_boundary(s), site = pieces_.sides[s].to;
    const bool passes = pieces_.is_edge_site(site) && pieces_.sides[s].neighbour == kNoCell &&
                        pieces_.sides[n].neighbour == kNoCell &&
                        inserted[pieces_.edge_site(site).crossing] == 0;
    if (!passes) loop.push_back(site);
    s = n;
  } while (s != first);
  return loop;
}

/// Component of each kept side: pieces joined across faces between unmarked cells.
std::vector<std::uint32_t> KeptPieces::components() const {
  UnionFind sets(pieces_.sides.size());
  for (std::uint32_t s = 0; s < pieces_.sides.size(); ++s) {
    const PieceSide& side = pieces_.sides[s];
    if (!kept(side)) continue;
    sets.join_to(side.next, s);
    if (!on_boundary(side)) sets.join_to(side.twin, s);
  }
  std::vector<std::uint32_t> component(sets.size());
  for (std::uint32_t s = 0; s < component.size(); ++s) component[s] = sets.root(s);
  return component;
}

bool KeptPieces::forbidden(std::uint32_t a, std::uint32_t b) const {
  if ((edges_at(pieces_, a) & edges_at(pieces_, b)) != 0) return true;
  if (part_ == Part::inside) return taken_.contains(std::minmax(global_[a], global_[b]));
  const NearCells x = near_cells(pieces_, a, in_), y = near_cells(pieces_, b, in_);
  for (int i = 0; i < x.count; ++i)
    for (int j = 0; j < y.count; ++j)
      if (x.cells[i] == y.cells[j]) return true;
  return false;
}

/// Whether triangles from so many corners across the whole of the cut one could cross the lattice
/// as often as its length squared, where its own cells follow its length.
bool KeptPieces::is_too_long(std::size_t corners) const {
  if (corners <= kMostDynamicCorners) return false;
  constexpr double kMost = 64;  // × the sides of the triangle's pieces
  const Triangle& v = in_.mesh.triangles[triangle_];
  double extent = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::minmax({in_.crossings.vertex_cell[v[0]][axis], in_.crossings.vertex_cell[v[1]][axis],
                     in_.crossings.vertex_cell[v[2]][axis]});
    extent += high - low;
  }
  return static_cast<double>(corners) * extent > kMost * static_cast<double>(pieces_.sides.size());
}

std::optional<std::vector<Triangle>> KeptPieces::triangulate(
    const std::vector<std::vector<std::uint32_t>>& loops) {
  PlanarRegion region;
  std::vector<std::uint32_t> local;  // corner of the region → local site
  std::vector<std::uint32_t> corner(global_.size(), kNone);
  for (const auto& loop : loops) {
    auto& indices = region.loops.emplace_back();
    for (const std::uint32_t site : loop) {
      if (corner[site] == kNone) {
        corner[site] = static_cast<std::uint32_t>(local.size());
        local.push_back(site);
        region.corners.push_back(sites_[global(site)].position);
      }
      indices.push_back(corner[site]);
    }
  }
  if (is_too_long(region.corners.size())) return std::nullopt;
  const Triangle& v = in_.mesh.triangles[triangle_];
  const auto& p = in_.mesh.positions;
  const Point u = p[v[1]] / 2 - p[v[0]] / 2, w = p[v[2]] / 2 - p[v[0]] / 2;
  region.normal =
      u.stableNormalized().cross(w.stableNormalized());  // products of lengths may overflow
  auto triangles = triangulate_planar(
      region, [&](std::uint32_t a, std::uint32_t b) { return forbidden(local[a], local[b]); });
  if (triangles)
    for (Triangle& t : *triangles)
      t = {global(local[t[0]]), global(local[t[1]]), global(local[t[2]])};
  return triangles;
}

std::optional<std::vector<Triangle>> KeptPieces::merged(const std::vector<char>& inserted) {
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<std::uint32_t> first;  // side of each loop
  std::vector<char> seen(pieces_.sides.size(), 0);
  for (std::uint32_t s = 0; s < pieces_.sides.size(); ++s)
    if (seen[s] == 0 && kept(pieces_.sides[s]) && on_boundary(pieces_.sides[s])) {
      first.push_back(s);
      loops.push_back(loop_from(s, inserted, seen));
      if (loops.back().size() < 3) return std::nullopt;
    }
  if (loops.size() < 2) return loops.empty() ? std::vector<Triangle>{} : triangulate(loops);
  const std::vector<std::uint32_t> component = components();
  std::map<std::uint32_t, std::vector<std::vector<std::uint32_t>>> together;
  for (std::size_t l = 0; l < loops.size(); ++l)
    together[component[first[l]]].push_back(std::move(loops[l]));
  std::vector<Triangle> all;
  for (const auto& [root, of_component] : together) {
    const auto triangles = triangulate(of_component);
    if (!triangles) return std::nullopt;
    all.insert(all.end(), triangles->begin(), triangles->end());
  }
  return all;
}

std::vector<Triangle> KeptPieces::cell_by_cell() {
  std::vector<Triangle> all;
  std::vector<char> seen(pieces_.sides.size(), 0);
  for (std::uint32_t first = 0; first < pieces_.sides.size(); ++first) {
    if (seen[first] != 0 || !kept(pieces_.sides[first])) continue;
    std::vector<std::uint32_t> loop;
    std::vector<Point> positions;
    for (std::uint32_t s = first; seen[s] == 0; s = pieces_.sides[s].next) {
      seen[s] = 1;
      loop.push_back(global(pieces_.sides[s].from));
      positions.push_back(sites_[loop.back()].position);
    }
    // A convex piece has at most 9 corners, and none of its diagonals can be an edge elsewhere.
    const auto triangles =
        least_area(positions, [](std::uint32_t, std::uint32_t) { return false; });
    if (!triangles) throw InternalFailure("cut", "a piece has no triangulation");
    for (const Triangle& t : *triangles) all.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
  }
  return all;
}

}  // namespace suture::surgery
