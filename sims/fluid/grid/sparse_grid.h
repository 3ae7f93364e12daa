// The physics grid: cells in blocks of 8³, of which only those near the liquid exist.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "kernel/lattice.h"

namespace suture::sims {

/// The place of a cell that exists in every array over the grid.
using Slot = std::size_t;
inline constexpr Slot kNoSlot = static_cast<Slot>(-1);

/// The places of cells, whether they exist or not: the low corner of cell (0,0,0), and a cell's
/// side.
struct GridFrame {
  Point origin = Point::Zero();
  double h = 0;
};

/// Cell (i,j,k) reaches from origin + h·(i,j,k) to origin + h·(i+1,j+1,k+1); indices may be
/// negative. A scene's box may be vast, as memory goes with the blocks that are there.
class SparseGrid {
 public:
  static constexpr int kSide = 8;
  static constexpr Slot kCells = 512;        ///< of a block
  static constexpr int kFurthest = 1 << 29;  ///< no cell's index is that far from 0
  /// The block that a cell's index is in. Rounds down, also below zero.
  static constexpr int block_of(int i) { return i >> 3; }

  SparseGrid() = default;

  /// The blocks that hold these cells, sorted, each once.
  /// \throw InvalidInput if h is not finite and positive, or a cell is 2^29 or further off
  SparseGrid(const Point& origin, double h, const std::vector<Index3>& cells);

  GridFrame frame() const { return {origin_, h_}; }
  double h() const { return h_; }
  const Point& origin() const { return origin_; }
  Slot size() const { return blocks_.size() * kCells; }  ///< slots
  /// The lowest cell of each block. Block b has the slots from b·kCells on, x slowest.
  const std::vector<Index3>& blocks() const { return blocks_; }

  Slot find(const Index3& cell) const {  ///< kNoSlot if it does not exist
    const std::uint32_t n = block({block_of(cell[0]), block_of(cell[1]), block_of(cell[2])});
    if (n == kNone) return kNoSlot;
    return n * kCells + static_cast<Slot>((cell[0] & 7) * 64 + (cell[1] & 7) * 8 + (cell[2] & 7));
  }
  Index3 cell(Slot s) const {
    const Index3& b = blocks_[s / kCells];
    const Index3 in = in_block(s);
    return {b[0] + in[0], b[1] + in[1], b[2] + in[2]};
  }
  /// The cell counted from the lowest of its block.
  static Index3 in_block(Slot s) {
    const int in = static_cast<int>(s % kCells);
    return {in / 64, in / 8 % 8, in % 8};
  }
  /// The cell next to s along `axis`, `side` being -1 or 1; kNoSlot if it does not exist.
  Slot neighbour(Slot s, int axis, int side) const {
    const int stride = axis == 0 ? 64 : axis == 1 ? 8 : 1;
    const int in = static_cast<int>(s % kCells) / stride % 8;
    if (side > 0 ? in < 7 : in > 0) return side > 0 ? s + stride : s - stride;
    const std::uint32_t b = next_[s / kCells][2 * axis + (side > 0 ? 1 : 0)];
    if (b == kNone) return kNoSlot;
    const Slot at = b * kCells + s % kCells;
    return side > 0 ? at - 7 * stride : at + 7 * stride;
  }

  Index3 cell_at(const Point& p) const;  ///< whether it exists or not
  Point centre(const Index3& c) const {
    return origin_ + h_ * Point(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
  }
  /// The middle of the cell's face across `axis` on its low side.
  Point face(const Index3& c, int axis) const {
    Point p = centre(c);
    p[axis] = origin_[axis] + h_ * c[axis];
    return p;
  }

 private:
  std::uint32_t block(const Index3& b) const {  // by the block's own indices
    if (table_.empty()) return hashed(b);
    std::size_t at = 0;
    for (int a = 0; a < 3; ++a) {
      const int in = b[a] - low_[a];
      if (in < 0 || in >= extent_[a]) return kNone;
      at = at * static_cast<std::size_t>(extent_[a]) + static_cast<std::size_t>(in);
    }
    return table_[at];
  }
  std::uint32_t hashed(const Index3& b) const;
  void index_blocks();  ///< blocks_ hold the blocks' own indices, in both
  void link_blocks();
  struct Hash {
    std::size_t operator()(const Index3& b) const;
  };

  double h_ = 0;
  Point origin_ = Point::Zero();
  std::vector<Index3> blocks_;
  std::vector<std::array<std::uint32_t, 6>> next_;
  // A table over the blocks' box where that is small, else by hash.
  Index3 low_{}, extent_{};
  std::vector<std::uint32_t> table_;
  std::unordered_map<Index3, std::uint32_t, Hash> map_;
};

/// A grid belongs to all that has arrays over it, together.
using SharedGrid = std::shared_ptr<const SparseGrid>;

/// \throw InvalidInput as SparseGrid
inline SharedGrid shared_grid(const Point& origin, double h, const std::vector<Index3>& cells) {
  return std::make_shared<const SparseGrid>(origin, h, cells);
}

}  // namespace suture::sims
