// Dense level sets from triangles and back.
#include "sims/baselines/grid/level_set_surface.h"

#include <algorithm>

#include "kernel/isosurface/marching_tetrahedra.h"
#include "kernel/measure/signed_distance.h"

namespace suture::sims {
namespace {

constexpr double kOffNodes = 1e-6;  ///< parts of an edge: a vertex on a node would be many vertices

/// 1 at each node that is within `width` of some triangle's bounding box.
std::vector<std::uint8_t> near_triangles(const Triangles& surface, const GridFrame& frame,
                                         const NodeBox& box, double width) {
  std::vector<std::uint8_t> marked(box.count(), 0);
  for (const Triangle& t : surface.triangles) {
    std::vector<Point> corners;
    for (const std::uint32_t v : t) corners.push_back(frame.cells(surface.positions[v]));
    const Box round = bounding_box(corners);
    Index3 low, high;
    for (int a = 0; a < 3; ++a) {
      low[a] = static_cast<int>(std::ceil(round.low[a] - width));
      high[a] = static_cast<int>(std::floor(round.high[a] + width));
    }
    for (int i = low[0]; i <= high[0]; ++i)
      for (int j = low[1]; j <= high[1]; ++j) {
        const auto row = marked.begin() + static_cast<std::ptrdiff_t>(box.at({i, j, low[2]}));
        std::fill(row, row + (high[2] - low[2] + 1), std::uint8_t{1});
      }
  }
  return marked;
}

}  // namespace

DenseLevelSet dense_level_set(const Triangles& surface, const GridFrame& frame, double width) {
  Box cells = bounding_box(surface.positions);
  cells = {frame.cells(cells.low), frame.cells(cells.high)};
  DenseLevelSet set{node_box(cells, static_cast<int>(std::ceil(width)) + 2), {}, width};
  set.phi.resize(set.box.count());
  const SignedDistance distance(surface);
  const auto marked = near_triangles(surface, frame, set.box, width);
  double before = width;  // sides only change between marked nodes, and rows begin outside
  for (std::size_t n = 0; n < set.phi.size(); ++n) {
    if (marked[n]) {
      const Index3 node = set.box.node(n);
      before = distance.at(frame.scene(Point(node[0], node[1], node[2]))) / frame.cell_size;
      set.phi[n] = std::clamp(before, -width, width);
    } else {
      set.phi[n] = before < 0 ? -width : width;
    }
  }
  return set;
}

Triangles zero_surface(const DenseLevelSet& set, const GridFrame& frame) {
  MarchingTetrahedra marching([&](const CubeCorner& from, const CubeCorner& to) {
    const Point a(from.node[0], from.node[1], from.node[2]);
    const Point b(to.node[0], to.node[1], to.node[2]);
    return frame.scene(a + linear_zero(from.value, to.value, kOffNodes) * (b - a));
  });
  const NodeBox& box = set.box;
  for (int i = 0; i + 1 < box.size[0]; ++i)
    for (int j = 0; j + 1 < box.size[1]; ++j)
      for (int k = 0; k + 1 < box.size[2]; ++k) {
        const Index3 lowest{box.low[0] + i, box.low[1] + j, box.low[2] + k};
        const std::size_t at = box.at(lowest);
        std::array<CubeCorner, 8> corners;
        int inside = 0;
        for (int c = 0; c < 8; ++c) {
          const Index3 node = cube_corner(lowest, c);
          const std::size_t n = at + (c & 1 ? box.stride(0) : 0) + (c & 2 ? box.stride(1) : 0) +
                                (c & 4 ? box.stride(2) : 0);
          corners[c] = {node, n, set.phi[n]};
          inside += set.phi[n] < 0;
        }
        if (inside > 0 && inside < 8) marching.add_cube(corners);
      }
  return marching.take();
}

}  // namespace suture::sims
