// The physics grid: cells in blocks of 8³, of which only those near the liquid exist.
#include "sims/fluid/grid/sparse_grid.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/hash.h"
#include "kernel/lists.h"

namespace suture::sims {
namespace {

constexpr std::int64_t kLargestTable = 1 << 20;  // blocks; beyond it a hash costs less

}  // namespace

SparseGrid::SparseGrid(const Point& origin, double h, const std::vector<Index3>& cells)
    : h_(h), origin_(origin) {
  if (!(h > 0) || !std::isfinite(h) || !origin.allFinite())
    throw InvalidInput("the physics grid needs cells of a finite positive size");
  for (const Index3& c : cells) {
    for (const int i : c)
      if (std::abs(i) >= kFurthest)
        throw InvalidInput("the liquid is 2^29 cells or further from the physics grid's origin");
    const Index3 b{block_of(c[0]), block_of(c[1]), block_of(c[2])};
    if (blocks_.empty() || blocks_.back() != b) blocks_.push_back(b);
  }
  sort_unique(blocks_);
  if (blocks_.empty()) return;
  Index3 high = low_ = blocks_.front();
  for (const Index3& b : blocks_)
    for (int a = 0; a < 3; ++a) {
      low_[a] = std::min(low_[a], b[a]);
      high[a] = std::max(high[a], b[a]);
    }
  double table = 1;
  for (int a = 0; a < 3; ++a) {
    extent_[a] = high[a] - low_[a] + 1;
    table *= extent_[a];
  }
  if (table <= kLargestTable) table_.assign(static_cast<std::size_t>(table), kNone);
  for (std::uint32_t n = 0; n < blocks_.size(); ++n) {
    const Index3& b = blocks_[n];
    if (table_.empty())
      map_[b] = n;
    else
      table_[static_cast<std::size_t>(
          ((b[0] - low_[0]) * extent_[1] + b[1] - low_[1]) * extent_[2] + b[2] - low_[2])] = n;
  }
  next_.resize(blocks_.size());
  for (std::size_t n = 0; n < blocks_.size(); ++n)
    for (int a = 0; a < 3; ++a)
      for (const int side : {0, 1}) {
        Index3 b = blocks_[n];
        b[a] += side == 0 ? -1 : 1;
        next_[n][2 * a + side] = block(b);
      }
  for (Index3& b : blocks_)
    for (int& i : b) i *= kSide;
}

std::uint32_t SparseGrid::hashed(const Index3& b) const {
  const auto at = map_.find(b);
  return at == map_.end() ? kNone : at->second;
}

/// Each index enters with all its bits and is spread over all of the hash's.
std::size_t SparseGrid::Hash::operator()(const Index3& b) const {
  std::uint64_t x = 0;
  for (const int i : b) x = spread(x + static_cast<std::uint32_t>(i) + kGoldenStep);
  return static_cast<std::size_t>(x);
}

Index3 SparseGrid::cell_at(const Point& p) const {
  Index3 c;
  for (int a = 0; a < 3; ++a)
    c[a] = static_cast<int>(
        std::clamp(std::floor((p[a] - origin_[a]) / h_), -1.0 * kFurthest, 1.0 * kFurthest));
  return c;
}

}  // namespace suture::sims
