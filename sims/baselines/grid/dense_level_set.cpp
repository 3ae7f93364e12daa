// A dense box of distances: its nodes, its normals, and where the surface passes between nodes.
#include "sims/baselines/grid/dense_level_set.h"

#include "kernel/errors.h"

namespace suture::sims {

Index3 NodeBox::node(std::size_t at) const {
  const auto y = static_cast<std::size_t>(size[1]), z = static_cast<std::size_t>(size[2]);
  return {low[0] + static_cast<int>(at / (y * z)), low[1] + static_cast<int>(at / z % y),
          low[2] + static_cast<int>(at % z)};
}

NodeBox node_box(const Box& cells, int margin) {
  constexpr double kMostNodes = 0x1p28, kLargestIndex = 0x1p30;
  NodeBox box;
  double nodes = 1;
  for (int a = 0; a < 3; ++a) {
    const double low = std::floor(cells.low[a]) - margin, high = std::ceil(cells.high[a]) + margin;
    nodes *= high - low + 1;
    if (!(std::abs(low) < kLargestIndex && std::abs(high) < kLargestIndex && nodes < kMostNodes))
      throw InvalidInput("level set: its box would reach from " + number(low) + " to " +
                         number(high) + " cells along axis " + std::to_string(a) +
                         ", more nodes than 2^28 in all; take larger cells or smaller steps");
    box.low[a] = static_cast<int>(low);
    box.size[a] = static_cast<int>(high - low) + 1;
  }
  return box;
}

Point DenseLevelSet::normal(const Point& p) const {
  Point gradient;
  for (int a = 0; a < 3; ++a) gradient[a] = sample(p + Point::Unit(a)) - sample(p - Point::Unit(a));
  const double length = gradient.norm();
  return length > 0 ? Point(gradient / length) : Point(Point::Zero());
}

std::vector<std::size_t> interface_nodes(const DenseLevelSet& set) {
  const NodeBox& box = set.box;
  std::vector<std::size_t> found;
  for (int i = 1; i < box.size[0] - 1; ++i)
    for (int j = 1; j < box.size[1] - 1; ++j) {
      const std::size_t row =
          static_cast<std::size_t>(i) * box.stride(0) + static_cast<std::size_t>(j) * box.stride(1);
      for (std::size_t n = row + 1; n + 1 < row + box.stride(1); ++n) {
        const bool inside = set.phi[n] < 0;
        bool differs = false;
        for (int a = 0; a < 3; ++a)
          differs = differs || (set.phi[n - box.stride(a)] < 0) != inside ||
                    (set.phi[n + box.stride(a)] < 0) != inside;
        if (differs) found.push_back(n);
      }
    }
  return found;
}

}  // namespace suture::sims
