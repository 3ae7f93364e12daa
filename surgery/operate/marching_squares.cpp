// Arcs on the faces between two cells of the region, from the sides of the face's four nodes.
#include <array>

#include "kernel/errors.h"
#include "surgery/operate/fill.h"

namespace suture::surgery {

namespace {

struct FaceCorner {
  Index3 node;
  LatticeId edge;  // from this corner to the next, counter-clockwise seen from above
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

/// Emits the arcs of one interior face to the cells below and above it.
void march(LatticeId face, int axis, const Winding& winding, Sites& sites, std::vector<Arc>& arcs) {
  const std::array<FaceCorner, 4> corner = corners_of(face, axis);
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

}  // namespace

std::vector<Arc> gather_arcs(std::vector<Arc> boundary, const Region& region,
                             const Winding& winding, Sites& sites) {
  std::vector<Arc> arcs = std::move(boundary);
  for (const LatticeId cell : region.cells.keys())
    for (int axis = 0; axis < 3; ++axis) {
      const LatticeId above = step(cell, axis, 1);
      if (region.holds(above)) march(above, axis, winding, sites, arcs);
    }
  return arcs;
}

}  // namespace suture::surgery
