// Boxes of cells that hold all active cells of a sparse grid, as few as blocks allow.
#pragma once

#include <cstdint>
#include <vector>

#include "sims/fluid/grid/sparse_grid.h"

namespace suture::sims {

struct CellBox {
  Index3 low, high;  ///< both in it

  std::size_t cells() const {
    std::size_t n = 1;
    for (int a = 0; a < 3; ++a) n *= static_cast<std::size_t>(high[a] - low[a] + 1);
    return n;
  }
};

/// Blocks with an active cell, joined to boxes along the last axis, those along the one before and
/// those along the first, then cut down to their active cells. No two overlap, and all cells of
/// each exist. In the order of the lowest blocks.
std::vector<CellBox> active_boxes(const SparseGrid& grid, const std::vector<std::uint8_t>& active);

}  // namespace suture::sims
