// Marching squares on the region's faces, and one disc for each loop of their arcs: the case table
// of marching cubes is not needed [§6.1 step 5].
#include "surgery/operate/fill.h"

#include <algorithm>
#include <array>

#include "kernel/errors.h"
#include "surgery/operate/triangulate.h"

namespace suture::surgery {

namespace {

struct FaceCorner {
  Index3 node;
  LatticeId edge;  ///< from this corner to the next, counter-clockwise seen from above
  int edge_axis;
};

std::array<FaceCorner, 4> corners_of(LatticeId face, int axis) {
  const int b = next_axis(axis), c = prev_axis(axis);
  const LatticeId right = step(face, b, 1), up = step(face, c, 1);
  return {{{unpack(face), face, b},
           {unpack(right), right, c},
           {unpack(step(right, c, 1)), up, b},
           {unpack(up), face, c}}};
}

/// A face between two cells of the region, by its upper cell.
struct InnerFace {
  LatticeId face;
  int axis;
};

/// Emits the arcs of the face to the cells below and above it.
void march(const InnerFace& at, Sites& sites, std::vector<Arc>& arcs) {
  const auto [face, axis] = at;
  const std::array<FaceCorner, 4> corner = corners_of(face, axis);
  const Winding& winding = sites.detected().winding;
  std::array<bool, 4> inside;
  for (std::size_t k = 0; k < 4; ++k) inside[k] = winding.inside(corner[k].node);
  auto site = [&](std::size_t k) {
    return sites.on_lattice_edge(corner[k].edge_axis, corner[k].edge);
  };
  for (std::size_t k = 0; k < 4; ++k) {
    if (inside[k] || !inside[(k + 1) % 4]) continue;  // corner k → k+1 enters the material
    std::size_t leave = (k + 1) % 4;
    while (inside[(leave + 1) % 4]) leave = (leave + 1) % 4;
    // Seen from above, the material is on the right of the way from entry to exit.
    const std::uint32_t from = site(k), to = site(leave);
    arcs.push_back({step(face, axis, -1), 2 * axis + 1, from, to});
    arcs.push_back({face, 2 * axis, to, from});
  }
}

/// A loop of sites with, for each, the bits of the cell's faces that it lies on.
struct Loop {
  std::vector<std::uint32_t> sites;
  std::vector<int> faces;
};

/// Takes the arcs of one cell apart into loops. \pre arcs sorted by `from`
std::vector<Loop> link(const Arc* begin, const Arc* end) {
  std::vector<Loop> loops;
  std::vector<char> used(static_cast<std::size_t>(end - begin), 0);
  for (const Arc* first = begin; first != end; ++first) {
    if (used[first - begin] != 0) continue;
    Loop loop;
    const Arc* at = first;
    do {
      used[at - begin] = 1;
      const Arc* next = std::lower_bound(
          begin, end, at->to, [](const Arc& a, std::uint32_t from) { return a.from < from; });
      if (next == end || next->from != at->to || (next != first && used[next - begin] != 0) ||
          (next + 1 != end && next[1].from == next->from))
        throw InternalFailure("fill", "the arcs round a cell do not close to loops");
      loop.sites.push_back(next->from);
      loop.faces.push_back(1 << at->face | 1 << next->face);
      at = next;
    } while (at != first);
    if (loop.sites.size() < 3)
      throw InternalFailure("fill", "a loop has fewer than three vertices");
    loops.push_back(std::move(loop));
  }
  return loops;
}

void fan(const Loop& loop, Sites& sites, Patch& patch) {
  Point middle = Point::Zero();
  for (const std::uint32_t s : loop.sites)
    middle += sites[s].position / static_cast<double>(loop.sites.size());
  const std::uint32_t centre = sites.centroid(middle);
  ++patch.centroids;
  for (std::size_t i = 0; i < loop.sites.size(); ++i)
    patch.triangles.push_back({centre, loop.sites[i], loop.sites[(i + 1) % loop.sites.size()]});
}

void fill_loop(const Loop& loop, Sites& sites, Patch& patch) {
  ++patch.loops;
  std::vector<Point> positions;
  for (const std::uint32_t s : loop.sites) positions.push_back(sites[s].position);
  std::optional<std::vector<Triangle>> triangles;
  if (loop.sites.size() <= kMostDynamicCorners)
    triangles = least_area(positions, [&](std::uint32_t i, std::uint32_t j) {
      return (loop.faces[i] & loop.faces[j]) != 0;
    });
  if (!triangles) return fan(loop, sites, patch);
  for (const Triangle& t : *triangles)
    patch.triangles.push_back({loop.sites[t[0]], loop.sites[t[1]], loop.sites[t[2]]});
}

}  // namespace

std::vector<Arc> gather_arcs(std::vector<Arc> boundary, Sites& sites) {
  const Region& region = sites.detected().region;
  std::vector<Arc> arcs = std::move(boundary);
  for (const LatticeId cell : region.cells.keys())
    for (int axis = 0; axis < 3; ++axis) {
      const LatticeId above = step(cell, axis, 1);
      if (region.holds(above)) march({above, axis}, sites, arcs);
    }
  return arcs;
}

Patch fill(const std::vector<Arc>& arcs, Sites& sites) {
  std::vector<Arc> sorted = arcs;
  std::sort(sorted.begin(), sorted.end(), [](const Arc& a, const Arc& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.from < b.from;
  });
  Patch patch;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].cell == sorted[begin].cell) ++end;
    for (const Loop& loop : link(sorted.data() + begin, sorted.data() + end))
      fill_loop(loop, sites, patch);
  }
  return patch;
}

}  // namespace suture::surgery
