// Which cells of the physics grid are liquid, from the tracked surface.
#include "sims/fluid/liquid/liquid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "kernel/lists.h"
#include "kernel/measure/measures.h"
#include "sims/fluid/liquid/surface_cells.h"

namespace suture::sims {
namespace {

constexpr int kSide = SparseGrid::kSide;

/// Gives the cells between near ones the sign of those, row by row along the last axis: no triangle
/// comes between them.
void fill_between(LiquidCells& cells) {
  const std::vector<Index3>& blocks = cells.grid.blocks();
  const double far = kFar * cells.grid.h();
  const auto same_row = [&](std::size_t a, std::size_t b) {
    return blocks[a][0] == blocks[b][0] && blocks[a][1] == blocks[b][1];
  };
  for (std::size_t first = 0, last = 0; first < blocks.size(); first = last) {
    while (last < blocks.size() && same_row(first, last)) ++last;
    for (int row = 0; row < kSide * kSide; ++row) {
      bool inside = false;
      int above = blocks[first][2];  // the first cell that this row has no block for so far
      for (std::size_t b = first; b < last; ++b) {
        if (inside && above < blocks[b][2]) {
          const int x = blocks[b][0] + row / kSide, y = blocks[b][1] + row % kSide;
          cells.deep.push_back({{x, y, above}, blocks[b][2] - above});
        }
        above = blocks[b][2] + kSide;
        const Slot begin = b * SparseGrid::kCells + static_cast<Slot>(row * kSide);
        for (Slot s = begin; s < begin + kSide; ++s)
          if (cells.near[s] != 0)
            inside = cells.distance[s] < 0;
          else
            cells.distance[s] = inside ? -far : far;
      }
    }
  }
  const auto before = [](const LiquidCells::Run& a, const LiquidCells::Run& b) {
    return a.first < b.first;
  };
  std::sort(cells.deep.begin(), cells.deep.end(), before);
}

template <class Visit>
void visit_cells(const CellRange& range, Visit visit) {
  for (int x = range.low[0]; x <= range.high[0]; ++x)
    for (int y = range.low[1]; y <= range.high[1]; ++y)
      for (int z = range.low[2]; z <= range.high[2]; ++z) visit(Index3{x, y, z});
}

/// Bodies of which no triangle has a cell inside next to it hold no cell's centre.
void find_drops(const Triangles& surface, LiquidCells& cells) {
  const Components bodies = components(surface);
  std::vector<std::uint8_t> holds(bodies.count, 0);
  const auto round = [&](std::size_t t, double wider) {
    return cells_round(in_cells(surface, surface.triangles[t], cells.grid), wider);
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::uint8_t& held = holds[bodies.of_triangle[t]];
    if (held != 0) continue;
    visit_cells(round(t, 1), [&](const Index3& c) {
      if (const Slot s = cells.grid.find(c); s != kNoSlot && cells.distance[s] < 0) held = 1;
    });
  }
  std::vector<std::uint32_t> number(bodies.count, kNone);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const std::uint32_t body = bodies.of_triangle[t];
    if (holds[body] != 0) continue;
    if (number[body] == kNone) {
      number[body] = static_cast<std::uint32_t>(cells.drops.size());
      cells.drops.emplace_back();
    }
    Drop& drop = cells.drops[number[body]];
    drop.vertices.insert(drop.vertices.end(), surface.triangles[t].begin(),
                         surface.triangles[t].end());
    visit_cells(round(t, 0.5), [&](const Index3& c) { drop.cells.push_back(c); });
  }
  for (Drop& drop : cells.drops) {
    sort_unique(drop.vertices);
    sort_unique(drop.cells);
  }
}

/// D of the near cells: the first alone, as a tracker may prepare something then.
void ask_near(const DistanceFunction& distance, LiquidCells& cells) {
  const SparseGrid& grid = cells.grid;
  const auto ask = [&](Slot s) { cells.distance[s] = distance(grid.centre(grid.cell(s))); };
  const auto first = std::find(cells.near.begin(), cells.near.end(), 1);
  if (first == cells.near.end()) return;
  ask(static_cast<Slot>(first - cells.near.begin()));
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, grid.blocks().size()), [&](const auto& range) {
        for (Slot s = range.begin() * SparseGrid::kCells; s < range.end() * SparseGrid::kCells; ++s)
          if (cells.near[s] != 0) ask(s);
      });
}

}  // namespace

LiquidCells find_liquid(const Triangles& surface, const DistanceFunction& distance,
                        const Point& origin, double h, int near) {
  LiquidCells cells;
  cells.grid = blocks_near(surface, origin, h, near);
  cells.near = cells_near(surface, cells.grid, near);
  cells.distance.assign(cells.grid.size(), 0);
  ask_near(distance, cells);
  fill_between(cells);
  for (int a = 0; a < 3; ++a) cells.crossings[a] = crossings_along(surface, cells.grid, a);
  find_drops(surface, cells);
  return cells;
}

namespace {

/// Blocks, of which many are named again and again: no more are held than some twice those there.
struct BlockList {
  static constexpr std::size_t kFew = 4096;
  std::vector<Index3> all;
  std::size_t known = 0;  ///< the first so many are sorted, each once

  void tidy() {
    if (all.size() < 2 * known + kFew) return;
    sort_unique(all);
    known = all.size();
  }
};

/// One cell of each block that is within the band of a drop's cells: what drops have of a block
/// counts as the box round it, so that a block more at most is there, and none a cell.
void add_round_drops(const std::vector<Drop>& drops, int band, BlockList& blocks) {
  std::map<Index3, CellRange> boxes;  // by block
  for (const Drop& drop : drops)
    for (const Index3& c : drop.cells) {
      const Index3 block{SparseGrid::block_of(c[0]), SparseGrid::block_of(c[1]),
                         SparseGrid::block_of(c[2])};
      CellRange& box = boxes.try_emplace(block, CellRange{c, c}).first->second;
      for (int a = 0; a < 3; ++a) {
        box.low[a] = std::min(box.low[a], c[a]);
        box.high[a] = std::max(box.high[a], c[a]);
      }
    }
  for (auto [block, box] : boxes) {
    for (int a = 0; a < 3; ++a) {
      box.low[a] = SparseGrid::block_of(box.low[a] - band);
      box.high[a] = SparseGrid::block_of(box.high[a] + band);
    }
    visit_cells(box, [&](const Index3& n) {
      blocks.all.push_back({n[0] * kSide, n[1] * kSide, n[2] * kSide});
    });
    blocks.tidy();
  }
}

}  // namespace

SparseGrid grid_round(const LiquidCells& cells, int band) {
  const SparseGrid& grid = cells.grid;
  const int reach = (band + kSide - 1) / kSide, width = 2 * reach + 1;
  BlockList blocks;
  for (std::size_t b = 0; b < grid.blocks().size(); ++b) {
    // Which of the blocks round this one come within the band of one of its cells.
    std::vector<std::uint8_t> wanted(static_cast<std::size_t>(width * width * width), 0);
    for (Slot s = b * SparseGrid::kCells; s < (b + 1) * SparseGrid::kCells; ++s) {
      const bool surface = cells.near[s] != 0 && std::abs(cells.distance[s]) < grid.h();
      if (!surface && !(cells.distance[s] < 0)) continue;
      const int wide = surface ? band : 0;  // far inside, the surface's cells have the band's
      const Index3 in = SparseGrid::in_block(s);
      Index3 low, high;  // blocks, from the lowest of those round this one
      for (int a = 0; a < 3; ++a) {
        low[a] = (in[a] - wide + reach * kSide) / kSide;
        high[a] = (in[a] + wide + reach * kSide) / kSide;
      }
      visit_cells({low, high}, [&](const Index3& n) {
        wanted[static_cast<std::size_t>((n[0] * width + n[1]) * width + n[2])] = 1;
      });
    }
    visit_cells({{0, 0, 0}, {width - 1, width - 1, width - 1}}, [&](const Index3& n) {
      if (wanted[static_cast<std::size_t>((n[0] * width + n[1]) * width + n[2])] == 0) return;
      Index3 block = grid.blocks()[b];
      for (int a = 0; a < 3; ++a) block[a] += (n[a] - reach) * kSide;
      blocks.all.push_back(block);
    });
    blocks.tidy();
  }
  for (const LiquidCells::Run& run : cells.deep)
    for (int n = 0; n < run.count; n += kSide)
      blocks.all.push_back({run.first[0], run.first[1], run.first[2] + n});
  add_round_drops(cells.drops, band, blocks);
  return {grid.origin(), grid.h(), blocks.all};
}

double Liquid::share(int axis, Slot face) const {
  const Slot below = grid->neighbour(face, axis, -1);
  const auto at = std::lower_bound(crossings[axis].begin(), crossings[axis].end(), face,
                                   [](const FaceCrossing& c, Slot s) { return c.face < s; });
  const bool found = at != crossings[axis].end() && at->face == face;
  if (inside(below))
    return found ? at->highest : distance[below] / (distance[below] - distance[face]);
  return found ? 1 - at->lowest : distance[face] / (distance[face] - distance[below]);
}

std::size_t Liquid::memory() const {
  std::size_t bytes = distance.size() * sizeof(double) + drops.size() * sizeof(Slot);
  for (const auto& along : crossings) bytes += along.size() * sizeof(FaceCrossing);
  return bytes;
}

}  // namespace suture::sims
