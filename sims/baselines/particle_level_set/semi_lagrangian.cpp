// Semi-Lagrangian steps: which nodes to fill, and where their paths come from.
#include "sims/baselines/particle_level_set/semi_lagrangian.h"

#include <algorithm>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

class Step {
 public:
  Step(const DenseLevelSet& old, const GridVelocity& u, const BackTrace& trace)
      : old_(old), u_(u), trace_(trace), nodes_(interface_nodes(old)) {}

  DenseLevelSet take() const {
    // Whole cells a path may have: the band is then wide enough that its outermost nodes are not
    // next to the new surface.
    int path = 1;
    for (;;) {
      const int reach = std::max(static_cast<int>(std::ceil(old_.width)), path + 2);
      DenseLevelSet set{box_round(reach), {}, old_.width};
      set.phi.resize(set.box.count());
      const double longest = fill(set, dilated(set.box, reach));
      if (longest <= reach - 2) return set;
      if (!(longest < 0x1p30))
        throw InvalidInput("level set: a step of " + number(trace_.path.dt) + " moves it by " +
                           number(longest) + " cells; take smaller steps");
      path = static_cast<int>(std::ceil(longest));
    }
  }

 private:
  /// The box of all nodes within `reach` of those next to the surface, and of what has to be
  /// covered.
  NodeBox box_round(int reach) const {
    const Box& cover = trace_.cover;
    Box cells{cover.low, cover.high};
    bool empty = (cover.low.array() > cover.high.array()).any();
    for (const std::size_t n : nodes_) {
      const Index3 node = old_.box.node(n);
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

  /// 1 at all nodes of the box within `reach` of those next to the surface, along each axis.
  std::vector<std::uint8_t> dilated(const NodeBox& box, int reach) const {
    std::vector<std::uint8_t> marked(box.count(), 0);
    for (const std::size_t n : nodes_) {
      const Index3 node = old_.box.node(n);
      for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
          const auto row =
              marked.begin() +
              static_cast<std::ptrdiff_t>(box.at({node[0] + i, node[1] + j, node[2] - reach}));
          std::fill(row, row + 2 * reach + 1, std::uint8_t{1});
        }
    }
    return marked;
  }

  /// Fills the marked nodes from their paths, the others with ± width by the side of the node
  /// before them: sides only change between marked nodes. \return the longest path, in cells
  double fill(DenseLevelSet& set, const std::vector<std::uint8_t>& marked) const {
    const PathStep back = trace_.path.back();
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
          const Point from = path_end(u_, p, back);
          longest = std::max(longest, (from - p).cwiseAbs().maxCoeff());
          if (!from.allFinite())
            throw InvalidInput(
                "level set: the velocity is not finite near node (" +
                std::to_string(set.box.low[0] + i) + ", " + std::to_string(set.box.low[1] + j) +
                ", " + std::to_string(set.box.low[2] + k) + "); give one that is everywhere");
          before = set.phi[n] = old_.sample(from);
        }
      }
    return longest;
  }

  const DenseLevelSet& old_;
  const GridVelocity& u_;
  const BackTrace& trace_;
  std::vector<std::size_t> nodes_;  ///< those next to the surface
};

}  // namespace

DenseLevelSet semi_lagrangian(const DenseLevelSet& old, const GridVelocity& u,
                              const BackTrace& trace) {
  return Step(old, u, trace).take();
}

}  // namespace suture::sims
