// MacCormack's semi-Lagrangian step in a narrow band: forth, back, and half the error [Selle 2008].
#include "sims/baselines/level_set/mac_cormack.h"

#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/Morphology.h>
#include <openvdb/tools/Prune.h>
#include <openvdb/tree/LeafManager.h>

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"

namespace suture::sims {
namespace {

using openvdb::FloatGrid;
using Leaves = openvdb::tree::LeafManager<openvdb::FloatTree>;

constexpr double kLongestPath = 1000;  // cells

/// A trilinear value, and the range of the eight that it comes from.
struct Sample {
  float value, least, most;
  bool within(float background) const { return least > -background && most < background; }
};

Sample sample(FloatGrid::ConstAccessor& values, const Point& p) {
  const openvdb::Coord low = openvdb::Coord::floor(openvdb::Vec3d(p[0], p[1], p[2]));
  float corners[2][2][2];
  openvdb::tools::BoxSampler::getValues(corners, values, low);
  Sample s{};
  openvdb::tools::BoxSampler::extrema(corners, s.least, s.most);
  s.value = openvdb::tools::BoxSampler::trilinearInterpolation(
      corners, openvdb::Vec3d(p[0], p[1], p[2]) - low.asVec3d());
  return s;
}

Point point(const openvdb::Coord& node) { return Point(node[0], node[1], node[2]); }

/// Nodes that the surface's band may reach, with the values that are there now.
FloatGrid::Ptr reachable(const FloatGrid& grid, const GridVelocity& u, const MacCormackStep& step) {
  openvdb::tree::LeafManager<const openvdb::FloatTree> leaves(grid.tree());
  const double longest = tbb::parallel_reduce(
      leaves.leafRange(), 0.0,
      [&](const auto& range, double most) {
        for (auto leaf = range.begin(); leaf; ++leaf)
          for (auto at = leaf->cbeginValueOn(); at; ++at) {
            const Point p = point(at.getCoord());
            const Point end = path_end(u, p, step.path);
            const double length = (end - p).lpNorm<Eigen::Infinity>();
            if (!(length < kLongestPath))
              throw InvalidInput(
                  "a path within one step is not finite, or longer than 1000 cells; check the "
                  "velocity field or take shorter steps");
            most = std::max(most, length);
          }
        return most;
      },
      [](double a, double b) { return std::max(a, b); });
  FloatGrid::Ptr wide = grid.deepCopy();
  openvdb::tools::dilateActiveValues(wide->tree(), static_cast<int>(std::ceil(longest)) + 1,
                                     openvdb::tools::NN_FACE_EDGE_VERTEX,
                                     openvdb::tools::IGNORE_TILES);
  return wide;
}

class Step {
 public:
  Step(const FloatGrid& from, const GridVelocity& u, const MacCormackStep& step)
      : from_(from), u_(u), step_(step), background_(from.background()) {}

  FloatGrid::Ptr take() {
    first_ = reachable(from_, u_, step_);
    Leaves leaves(first_->tree());
    leaves.foreach ([this](auto& leaf, std::size_t) {
      FloatGrid::ConstAccessor values = from_.getConstAccessor();
      for (auto at = leaf.beginValueOn(); at; ++at)
        at.setValue(sample(values, back(at.getCoord())).value);
    });
    FloatGrid::Ptr result = first_->deepCopy();
    Leaves corrected(result->tree());
    corrected.foreach ([this](auto& leaf, std::size_t) { correct(leaf); });
    openvdb::tools::pruneLevelSet(result->tree());
    return result;
  }

 private:
  Point back(const openvdb::Coord& node) const {
    return path_end(u_, point(node), step_.path.back());
  }

  void correct(openvdb::FloatTree::LeafNodeType& leaf) const {
    // Nodes that the cut at the border only just holds off it would stay in the band for ever.
    const float border = background_ * (1 - 1e-3F);
    FloatGrid::ConstAccessor old = from_.getConstAccessor(), first = first_->getConstAccessor();
    for (auto at = leaf.beginValueOn(); at; ++at) {
      const openvdb::Coord node = at.getCoord();
      const float value = corrected(node, *at, old, first);
      if (std::abs(value) < border)
        at.setValue(value);
      else
        leaf.setValueOff(at.pos(), std::copysign(background_, value));
    }
  }

  float corrected(const openvdb::Coord& node, float value, FloatGrid::ConstAccessor& old,
                  FloatGrid::ConstAccessor& first) const {
    const float was = old.getValue(node);
    if (!(std::abs(was) < background_)) return value;
    const Sample source = sample(old, back(node));
    if (!source.within(background_)) return value;
    const Sample returned = sample(first, path_end(u_, point(node), step_.path));
    if (!returned.within(background_)) return value;
    const float better = value + (was - returned.value) / 2;
    if (step_.limiter == Limiter::none) return better;
    if (better >= source.least && better <= source.most) return better;
    return step_.limiter == Limiter::revert ? value : std::clamp(better, source.least, source.most);
  }

  const FloatGrid& from_;
  const GridVelocity& u_;
  const MacCormackStep& step_;
  float background_;
  FloatGrid::Ptr first_;  ///< after the first step, uncorrected
};

}  // namespace

FloatGrid::Ptr mac_cormack(const FloatGrid& grid, const GridVelocity& u,
                           const MacCormackStep& step) {
  return Step(grid, u, step).take();
}

}  // namespace suture::sims
