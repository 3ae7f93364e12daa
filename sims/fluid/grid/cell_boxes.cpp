// Boxes of cells that hold all active cells of a sparse grid, as few as blocks allow.
#include "sims/fluid/grid/cell_boxes.h"

#include <algorithm>

namespace suture::sims {
namespace {

constexpr int kSide = SparseGrid::kSide;

/// Joins blocks to boxes; each block is in one.
class Joiner {
 public:
  Joiner(const SparseGrid& grid, const std::vector<std::uint8_t>& active)
      : grid_(grid), free_(grid.blocks().size(), 0) {
    for (std::size_t b = 0; b < free_.size(); ++b) {
      const auto first = active.begin() + static_cast<std::ptrdiff_t>(b * SparseGrid::kCells);
      free_[b] = std::find(first, first + SparseGrid::kCells, 1) != first + SparseGrid::kCells;
    }
  }

  std::vector<CellBox> joined() {
    std::vector<CellBox> boxes;
    for (std::size_t b = 0; b < free_.size(); ++b) {
      if (free_[b] == 0) continue;
      CellBox box{grid_.blocks()[b], grid_.blocks()[b]};  // of blocks, by their lowest cells
      for (const int axis : {2, 1, 0})
        while (grows(box, axis)) box.high[axis] += kSide;
      visit(box, [&](std::size_t n) { free_[n] = 0; });
      for (int& i : box.high) i += kSide - 1;
      boxes.push_back(box);
    }
    return boxes;
  }

 private:
  /// Whether the blocks beyond the box's high side are there and free.
  bool grows(const CellBox& box, int axis) const {
    CellBox slab = box;
    slab.low[axis] = slab.high[axis] = box.high[axis] + kSide;
    bool all = true;
    visit(slab, [&](std::size_t n) { all = all && n < free_.size() && free_[n] != 0; });
    return all;
  }
  template <class Visit>
  void visit(const CellBox& blocks, Visit visit_block) const {
    for (int x = blocks.low[0]; x <= blocks.high[0]; x += kSide)
      for (int y = blocks.low[1]; y <= blocks.high[1]; y += kSide)
        for (int z = blocks.low[2]; z <= blocks.high[2]; z += kSide)
          visit_block(grid_.find({x, y, z}) / SparseGrid::kCells);  // of kNoSlot: past the end
  }

  const SparseGrid& grid_;
  std::vector<std::uint8_t> free_;
};

CellBox cut_down(const CellBox& box, const SparseGrid& grid,
                 const std::vector<std::uint8_t>& active) {
  CellBox cut{box.high, box.low};
  for (int x = box.low[0]; x <= box.high[0]; x += kSide)
    for (int y = box.low[1]; y <= box.high[1]; y += kSide)
      for (int z = box.low[2]; z <= box.high[2]; z += kSide) {
        const Slot first = grid.find({x, y, z});
        for (Slot s = first; s < first + SparseGrid::kCells; ++s) {
          if (active[s] == 0) continue;
          const Index3 c = grid.cell(s);
          for (int a = 0; a < 3; ++a) {
            cut.low[a] = std::min(cut.low[a], c[a]);
            cut.high[a] = std::max(cut.high[a], c[a]);
          }
        }
      }
  return cut;
}

}  // namespace

std::vector<CellBox> active_boxes(const SparseGrid& grid, const std::vector<std::uint8_t>& active) {
  std::vector<CellBox> boxes = Joiner(grid, active).joined();
  for (CellBox& box : boxes) box = cut_down(box, grid, active);
  return boxes;
}

}  // namespace suture::sims
