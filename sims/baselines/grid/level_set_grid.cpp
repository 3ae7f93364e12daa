// The ground of the baselines on grids: surfaces to narrow bands of distances, and zero sets to
// surfaces.
#include "sims/baselines/grid/level_set_grid.h"

#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/Prune.h>
#include <openvdb/tools/SignedFloodFill.h>
#include <openvdb/tree/LeafManager.h>

#include <cmath>
#include <string>

#include "kernel/errors.h"
#include "kernel/measure/signed_distance.h"

namespace suture::sims {
namespace {

using openvdb::Coord;

constexpr int kMostCells = 1 << 19;  // from the origin, so that three indices fit an id
constexpr int kRootBlock = 64;       // nodes; a leaf is one of 8
constexpr int kLeastBlock = 4;       // nodes; below it asking for a block costs more than it saves

template <class Grid>
typename Grid::Ptr empty_grid(const BandOptions& o) {
  const auto grid = Grid::create(static_cast<typename Grid::ValueType>(o.half_width));
  grid->setTransform(openvdb::math::Transform::createLinearTransform(1.0));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  return grid;
}

/// A search for all blocks of kLeastBlock³ nodes that may hold nodes of the band. A block is far
/// where its centre is farther from the surface than its corners are from there.
template <class Visit>
struct BlockSearch {
  const NearestTriangle& nearest;
  const BandOptions& band;
  const Visit& visit;  ///< called with each block's lowest node

  void descend(const Coord& lowest, int size) const {
    constexpr double kSlack = 1 + 1e-9;  // for rounding
    const double half = 0.5 * (size - 1) * band.cell_size;
    const Point centre = band.place(lowest) + Point::Constant(half);
    const double reach = (band.half_width * band.cell_size + std::sqrt(3.0) * half) * kSlack;
    if (nearest.distance(centre) > reach) return;
    if (size == kLeastBlock) return visit(lowest);
    const int part = size / 2;
    for (int c = 0; c < 8; ++c)
      descend(lowest.offsetBy((c & 1) * part, (c >> 1 & 1) * part, (c >> 2) * part), part);
  }
};

openvdb::CoordBBox index_box(const Triangles& surface, const BandOptions& o) {
  const Box box = bounding_box(surface.positions);
  openvdb::CoordBBox cells;
  for (int a = 0; a < 3; ++a) {
    const double low = (box.low[a] - o.origin[a]) / o.cell_size - o.half_width - 1;
    const double high = (box.high[a] - o.origin[a]) / o.cell_size + o.half_width + 1;
    if (!(low > -kMostCells && high < kMostCells))
      throw InvalidInput("the surface is more than " + std::to_string(kMostCells) + " cells of " +
                         std::to_string(o.cell_size) +
                         " from the lattice's origin; choose larger cells");
    cells.min()[a] = static_cast<int>(std::floor(low));
    cells.max()[a] = static_cast<int>(std::ceil(high));
  }
  return cells;
}

/// A grid whose nodes near the surface are active; their values are to be set.
template <class Grid>
typename Grid::Ptr active_near(const Triangles& surface, const NearestTriangle& nearest,
                               const BandOptions& o) {
  const auto grid = empty_grid<Grid>(o);
  const openvdb::CoordBBox box = index_box(surface, o);
  const Coord low = box.min() & ~(kRootBlock - 1);
  auto values = grid->getAccessor();
  const auto activate = [&](const Coord& lowest) {
    for (int n = 0; n < kLeastBlock * kLeastBlock * kLeastBlock; ++n)
      values.setValueOn(lowest.offsetBy(n / 16, n / 4 % 4, n % 4));
  };
  const BlockSearch<decltype(activate)> search{nearest, o, activate};
  for (int i = low[0]; i <= box.max()[0]; i += kRootBlock)
    for (int j = low[1]; j <= box.max()[1]; j += kRootBlock)
      for (int k = low[2]; k <= box.max()[2]; k += kRootBlock)
        search.descend(Coord(i, j, k), kRootBlock);
  return grid;
}

/// Distances with signs at the active nodes of a leaf. A ball round a node that reaches as far as
/// the surface is on one side of it, so most nodes have their neighbour's sign.
void fill_leaf(openvdb::FloatTree::LeafNodeType& leaf, const SignedDistance& signed_distance,
               const BandOptions& o) {
  constexpr double kOneCell = 1 + 1e-9;  // with room for rounding
  openvdb::Index last = 0;
  double last_value = 0;
  for (auto at = leaf.beginValueOn(); at; ++at) {
    const Point p = o.place(at.getCoord());
    double value = signed_distance.nearest().distance(p) / o.cell_size;
    const bool neighbours = at.pos() % 8 != 0 && at.pos() == last + 1;
    if (neighbours && std::max(value, std::abs(last_value)) > kOneCell)
      value = std::copysign(value, last_value);
    else if (signed_distance.winding(p) > 0)
      value = -value;
    last = at.pos();
    last_value = value;
    if (std::abs(value) < o.half_width)
      at.setValue(static_cast<float>(value));
    else
      leaf.setValueOff(at.pos(), static_cast<float>(std::copysign(o.half_width, value)));
  }
}

openvdb::MaskTree::Ptr crossed_cubes(const auto& tree) {
  const auto cubes = std::make_shared<openvdb::MaskTree>();
  openvdb::tree::ValueAccessor<openvdb::MaskTree> mark(*cubes);
  openvdb::tree::ValueAccessor<const std::decay_t<decltype(tree)>> values(tree);
  const auto mark_round = [&](const Coord& from, int axis) {
    const int b = next_axis(axis), c = prev_axis(axis);
    for (int n = 0; n < 4; ++n) {
      Coord cube = from;
      cube[b] -= n & 1;
      cube[c] -= n >> 1;
      mark.setValueOn(cube);
    }
  };
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    for (openvdb::Index n = 0; n < leaf->SIZE; ++n) {
      const Coord at = leaf->offsetToGlobalCoord(n);
      const bool inside = leaf->getValue(n) < 0;
      for (int axis = 0; axis < 3; ++axis) {
        Coord next = at, before = at;
        ++next[axis];
        --before[axis];
        if ((values.getValue(next) < 0) != inside) mark_round(at, axis);
        if (at[axis] % 8 == 0 && (values.getValue(before) < 0) != inside)
          mark_round(before, axis);  // for where a tile is before this leaf
      }
    }
  return cubes;
}

std::uint64_t node_id(const Coord& node) {
  std::uint64_t id = 0;
  for (int a = 0; a < 3; ++a) id = id << 20 | static_cast<std::uint64_t>(node[a] + kMostCells);
  return id;
}

}  // namespace

void require_valid(const BandOptions& o) {
  if (!(std::isnormal(o.cell_size) && o.cell_size > 0 && o.origin.allFinite()))
    throw InvalidInput("a grid's cell_size must be positive and its origin finite");
  if (!(o.half_width >= 1 && o.half_width <= 1000))
    throw InvalidInput("a band's half_width is " + std::to_string(o.half_width) +
                       "; it must be 1 to 1000 cells");
}

void require_within_reach(const openvdb::FloatGrid& grid) {
  openvdb::CoordBBox box;
  if (!grid.tree().evalLeafBoundingBox(box)) return;
  const Coord low = box.min(), high = box.max();
  if (low[low.minIndex()] <= -kMostCells || high[high.maxIndex()] >= kMostCells)
    throw InvalidInput("the surface has moved more than " + std::to_string(kMostCells) +
                       " cells from the lattice's origin; choose larger cells");
}

openvdb::FloatGrid::Ptr make_level_set(const Triangles& surface, const BandOptions& o) {
  require_valid(o);
  if (surface.triangles.empty()) return empty_grid<openvdb::FloatGrid>(o);
  const SignedDistance distance(surface);
  auto grid = active_near<openvdb::FloatGrid>(surface, distance.nearest(), o);
  openvdb::tree::LeafManager<openvdb::FloatTree> leaves(grid->tree());
  leaves.foreach ([&](auto& leaf, std::size_t) { fill_leaf(leaf, distance, o); });
  openvdb::tools::pruneLevelSet(grid->tree());
  openvdb::tools::signedFloodFill(grid->tree());
  return grid;
}

openvdb::DoubleGrid::Ptr make_band(const Triangles& near, const BandOptions& o,
                                   const std::function<double(const Point&)>& value) {
  require_valid(o);
  auto grid = active_near<openvdb::DoubleGrid>(near, NearestTriangle(near), o);
  openvdb::tree::LeafManager<openvdb::DoubleTree> leaves(grid->tree());
  leaves.foreach ([&](auto& leaf, std::size_t) {
    for (auto at = leaf.beginValueOn(); at; ++at) at.setValue(value(o.place(at.getCoord())));
  });
  openvdb::tools::signedFloodFill(grid->tree());
  return grid;
}

bool holds_zero_set(const openvdb::DoubleGrid& grid) {
  const openvdb::MaskTree::Ptr cubes = crossed_cubes(grid.tree());
  auto values = grid.getConstAccessor();
  for (auto leaf = cubes->cbeginLeaf(); leaf; ++leaf)
    for (auto cube = leaf->cbeginValueOn(); cube; ++cube)
      for (int c = 0; c < 8; ++c)
        if (!values.isValueOn(cube.getCoord().offsetBy(c & 1, c >> 1 & 1, c >> 2))) return false;
  return true;
}

template <class Grid>
Triangles contour(const Grid& grid, const MarchingTetrahedra::Place& place) {
  MarchingTetrahedra marching(place);
  const openvdb::MaskTree::Ptr cubes = crossed_cubes(grid.tree());
  auto values = grid.getConstAccessor();
  for (auto leaf = cubes->cbeginLeaf(); leaf; ++leaf)
    for (auto cube = leaf->cbeginValueOn(); cube; ++cube) {
      std::array<CubeCorner, 8> corners;
      const Coord lowest = cube.getCoord();
      for (int c = 0; c < 8; ++c) {
        const Index3 node = cube_corner({lowest[0], lowest[1], lowest[2]}, c);
        const Coord at(node[0], node[1], node[2]);
        corners[c] = {node, node_id(at), static_cast<double>(values.getValue(at))};
      }
      marching.add_cube(corners);
    }
  return marching.take();
}
template Triangles contour(const openvdb::FloatGrid&, const MarchingTetrahedra::Place&);
template Triangles contour(const openvdb::DoubleGrid&, const MarchingTetrahedra::Place&);

Triangles contour(const openvdb::FloatGrid& grid, const BandOptions& o) {
  constexpr double kOffEnds = 1e-6;  // of an edge: vertices of different edges stay apart
  return contour(grid, [&](const CubeCorner& from, const CubeCorner& to) -> Point {
    const Point p = o.place(Coord(from.node[0], from.node[1], from.node[2]));
    const Point q = o.place(Coord(to.node[0], to.node[1], to.node[2]));
    return p + linear_zero(from.value, to.value, kOffEnds) * (q - p);
  });
}

double sampled(openvdb::FloatGrid::ConstAccessor& values, const openvdb::Vec3d& index) {
  return static_cast<double>(openvdb::tools::BoxSampler::sample(values, index));
}

}  // namespace suture::sims
