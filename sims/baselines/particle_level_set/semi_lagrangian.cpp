// Semi-Lagrangian steps: which nodes to fill, and where their paths come from.
#include "sims/baselines/particle_level_set/semi_lagrangian.h"

#include <algorithm>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

/// The box of all nodes within `reach` of the given ones, and of what has to be covered.
NodeBox box_round(const DenseLevelSet& old, const std::vector<std::size_t>& nodes, int reach,
                  const Box& cover) {
  Box cells{cover.low, cover.high};
  bool empty = (cover.low.array() > cover.high.array()).any();
  for (const std::size_t n : nodes) {
    const Index3 node = old.box.node(n);
    const Point p(node[0], node[1], node[2]);
    cells.low = empty ? Point(p - Point::Constant(reach))
                      : Point(cells.low.cwiseMin(p - Point::Constant(reach)));
    cells.high = empty ? Point(p + Point::Constant(reach))
                       : Point(cells.high.cwiseMax(p + Point::Constant(reach)));
    empty = false;
  }
  if (empty) cells = {Point::Zero(), Point::Zero()};
  return node_box(cells, 2);  // so that the border lies outside, and a cell's corners in the box
}

/// 1 at all nodes within `reach` of the given ones along each axis.
std::vector<std::uint8_t> dilated(const DenseLevelSet& old, const std::vector<std::size_t>& nodes,
                                  int reach, const NodeBox& box) {
  std::vector<std::uint8_t> marked(box.count(), 0);
  for (const std::size_t n : nodes) {
    const Index3 node = old.box.node(n);
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j) {
        const auto row = marked.begin() + static_cast<std::ptrdiff_t>(
                                              box.at({node[0] + i, node[1] + j, node[2] - reach}));
        std::fill(row, row + 2 * reach + 1, std::uint8_t{1});
      }
  }
  return marked;
}

/// Fills the marked nodes from their paths, the others with ± width by the side of the node before
/// them: sides only change between marked nodes. Returns the longest path, in cells.
double fill(DenseLevelSet& set, const std::vector<std::uint8_t>& marked, const DenseLevelSet& old,
            const GridVelocity& u, const BackTrace& trace) {
  double longest = 0;
  for (int i = 0; i < set.box.size[0]; ++i)
    for (int j = 0; j < set.box.size[1]; ++j) {
      std::size_t n = static_cast<std::size_t>(i) * set.box.stride(0) +
                      static_cast<std::size_t>(j) * set.box.stride(1);
      double before = set.width;
      for (int k = 0; k < set.box.size[2]; ++k, ++n) {
        if (!marked[n]) {
          set.phi[n] = before < 0 ? -set.width : set.width;
          continue;
        }
        const Point p(set.box.low[0] + i, set.box.low[1] + j, set.box.low[2] + k);
        const Point from = path_end(u, p, trace.time + trace.dt, -trace.dt, trace.order);
        longest = std::max(longest, (from - p).cwiseAbs().maxCoeff());
        if (!from.allFinite())
          throw InvalidInput("level set: the velocity is not finite near node (" +
                             std::to_string(set.box.low[0] + i) + ", " +
                             std::to_string(set.box.low[1] + j) + ", " +
                             std::to_string(set.box.low[2] + k) + "); give one that is everywhere");
        before = set.phi[n] = old.sample(from);
      }
    }
  return longest;
}

}  // namespace

DenseLevelSet semi_lagrangian(const DenseLevelSet& old, const GridVelocity& u,
                              const BackTrace& trace) {
  const std::vector<std::size_t> nodes = interface_nodes(old);
  // Whole cells a path may have: the band is then wide enough that its outermost nodes are not next
  // to the new surface.
  int path = 1;
  for (;;) {
    const int reach = std::max(static_cast<int>(std::ceil(old.width)), path + 2);
    DenseLevelSet set{box_round(old, nodes, reach, trace.cover), {}, old.width};
    set.phi.resize(set.box.count());
    const double longest = fill(set, dilated(old, nodes, reach, set.box), old, u, trace);
    if (longest <= reach - 2) return set;
    if (!(longest < 0x1p30))
      throw InvalidInput("level set: a step of " + number(trace.dt) + " moves it by " +
                         number(longest) + " cells; take smaller steps");
    path = static_cast<int>(std::ceil(longest));
  }
}

}  // namespace suture::sims
