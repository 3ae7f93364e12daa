// A closed surface on the physics grid: cells near it, and where it crosses between their centres.
#include "sims/fluid/grid/surface_cells.h"

#include <algorithm>
#include <utility>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

struct Corners {
  Point low, high;
};
Corners box_of(const CellTriangle& t) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

void check(const Triangles& surface, const GridFrame& frame) {
  for (std::size_t v = 0; v < surface.positions.size(); ++v)
    if (!(((surface.positions[v] - frame.origin) / frame.h).lpNorm<Eigen::Infinity>() <
          SparseGrid::kFurthest))
      throw InvalidInput("vertex " + std::to_string(v) +
                         " of the liquid is not finite, or 2^29 cells or further from the physics "
                         "grid's origin; use larger cells");
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t)
      if (v >= surface.positions.size())
        throw InvalidInput("a triangle of the liquid names vertex " + std::to_string(v) + " of " +
                           std::to_string(surface.positions.size()));
}

/// Twice the signed area of (u, v, p), the negative of that of (v, u, p) to the last bit.
double turn(const std::array<double, 2>& u, const std::array<double, 2>& v,
            const std::array<double, 2>& p) {
  if (v < u) return -turn(v, u, p);
  return (v[0] - u[0]) * (p[1] - u[1]) - (v[1] - u[1]) * (p[0] - u[0]);
}

/// The two axes across one, in order.
std::array<int, 2> axes_across(int axis) { return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2}; }

/// The triangle seen along an axis.
struct Shadow {
  std::array<std::array<double, 2>, 3> corners;
  std::array<double, 3> heights;

  Shadow(const CellTriangle& t, int axis) {
    const auto [b, c] = axes_across(axis);
    for (int k = 0; k < 3; ++k) {
      corners[k] = {t[k][b], t[k][c]};
      heights[k] = t[k][axis];
    }
  }
  /// Whether the line at p meets it, and at which height.
  bool meets(const std::array<double, 2>& p, double& height) const {
    std::array<double, 3> weight;
    for (int k = 0; k < 3; ++k) weight[k] = turn(corners[(k + 1) % 3], corners[(k + 2) % 3], p);
    const auto [least, most] = std::minmax({weight[0], weight[1], weight[2]});
    if (least < 0 && most > 0) return false;
    const double sum = weight[0] + weight[1] + weight[2];
    if (sum == 0) return false;  // seen from its edge: its neighbours are met
    const auto [bottom, top] = std::minmax({heights[0], heights[1], heights[2]});
    height = (weight[0] * heights[0] + weight[1] * heights[1] + weight[2] * heights[2]) / sum;
    height = std::clamp(height, bottom, top);
    return true;
  }
};

}  // namespace

CellTriangle in_cells(const Triangles& surface, const Triangle& triangle, const SparseGrid& grid) {
  CellTriangle t;
  for (int k = 0; k < 3; ++k)
    t[k] = (surface.positions[triangle[k]] - grid.origin()) / grid.h() - Point::Constant(0.5);
  return t;
}

CellRange cells_round(const CellTriangle& triangle, double wider) {
  const Corners box = box_of(triangle);
  CellRange range;
  for (int a = 0; a < 3; ++a) {
    range.low[a] = static_cast<int>(std::ceil(box.low[a] - wider));
    range.high[a] = static_cast<int>(std::floor(box.high[a] + wider));
  }
  return range;
}

SparseGrid blocks_near(const Triangles& surface, const GridFrame& frame, int width) {
  const SparseGrid none(frame.origin, frame.h, {});  // refuses an h that is none
  check(surface, frame);
  constexpr int side = SparseGrid::kSide;
  const auto down = [](int i) { return SparseGrid::block_of(i) * side; };
  std::vector<Index3> blocks;
  for (const Triangle& triangle : surface.triangles) {
    const CellRange range = cells_round(in_cells(surface, triangle, none), width);
    for (int x = down(range.low[0]); x <= range.high[0]; x += side)
      for (int y = down(range.low[1]); y <= range.high[1]; y += side)
        for (int z = down(range.low[2]); z <= range.high[2]; z += side) {
          const Index3 block{x, y, z};
          if (blocks.empty() || blocks.back() != block) blocks.push_back(block);
        }
  }
  return {frame.origin, frame.h, blocks};
}

std::vector<std::uint8_t> cells_near(const Triangles& surface, const SparseGrid& grid, int width) {
  std::vector<std::uint8_t> near(grid.size(), 0);
  const double squared = static_cast<double>(width) * width;
  for (const Triangle& triangle : surface.triangles) {
    const CellTriangle t = in_cells(surface, triangle, grid);
    const Corners box = box_of(t);
    const CellRange range = cells_round(t, width);
    const Point across = (t[1] - t[0]).cross(t[2] - t[0]);
    const double reach = width * across.norm();  // 0 where there is no plane: all are near it
    for (int x = range.low[0]; x <= range.high[0]; ++x)
      for (int y = range.low[1]; y <= range.high[1]; ++y) {
        Slot s = kNoSlot;
        for (int z = range.low[2]; z <= range.high[2]; ++z) {
          s = s == kNoSlot || z % SparseGrid::kSide == 0 ? grid.find({x, y, z}) : s + 1;
          const Point p(x, y, z);
          const Point off = (box.low - p).cwiseMax(p - box.high).cwiseMax(0);
          if (off.squaredNorm() <= squared && std::abs(across.dot(p - t[0])) <= reach) near[s] = 1;
        }
      }
  }
  return near;
}

std::vector<FaceCrossing> crossings_along(const Triangles& surface, const SparseGrid& grid,
                                          int axis) {
  const auto [b, c] = axes_across(axis);
  std::vector<std::pair<Slot, double>> found;
  for (const Triangle& triangle : surface.triangles) {
    const CellTriangle t = in_cells(surface, triangle, grid);
    const Shadow shadow(t, axis);
    const CellRange range = cells_round(t, 0);
    for (int i = range.low[b]; i <= range.high[b]; ++i)
      for (int j = range.low[c]; j <= range.high[c]; ++j) {
        double height = 0;
        if (!shadow.meets({static_cast<double>(i), static_cast<double>(j)}, height)) continue;
        const double below = std::floor(height);
        Index3 above;
        above[axis] = static_cast<int>(below) + 1;
        above[b] = i;
        above[c] = j;
        if (const Slot face = grid.find(above); face != kNoSlot)
          found.emplace_back(face, height - below);
      }
  }
  std::sort(found.begin(), found.end());
  std::vector<FaceCrossing> crossings;
  for (const auto& [face, at] : found)
    if (crossings.empty() || crossings.back().face != face)
      crossings.push_back({face, at, at});
    else
      crossings.back().highest = at;
  return crossings;
}

}  // namespace suture::sims
