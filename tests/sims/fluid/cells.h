// Boxes of cells for the tests of grids.
#pragma once

#include <vector>

#include "kernel/lattice.h"

namespace suture {

inline std::vector<Index3> cells_in(const Index3& low, const Index3& high) {
  std::vector<Index3> cells;
  for (int x = low[0]; x <= high[0]; ++x)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int z = low[2]; z <= high[2]; ++z) cells.push_back({x, y, z});
  return cells;
}

}  // namespace suture
