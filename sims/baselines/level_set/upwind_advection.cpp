// OpenVDB's level set tracker [Museth 2013]: upwind advection in a narrow band, re-normalised.
#include "sims/baselines/level_set/upwind_advection.h"

#include <openvdb/tools/LevelSetAdvect.h>
#include <openvdb/tools/Morphology.h>
#include <openvdb/tree/LeafManager.h>

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/parallel.h"

namespace suture::sims {
namespace {

using openvdb::math::BiasedGradientScheme;
using openvdb::math::TemporalIntegrationScheme;

BiasedGradientScheme scheme(UpwindScheme s) {
  switch (s) {
    case UpwindScheme::first:
      return openvdb::math::FIRST_BIAS;
    case UpwindScheme::second:
      return openvdb::math::SECOND_BIAS;
    case UpwindScheme::third:
      return openvdb::math::THIRD_BIAS;
    case UpwindScheme::weno5:
      break;
  }
  return openvdb::math::HJWENO5_BIAS;
}

TemporalIntegrationScheme integration(int order) {
  return order == 1   ? openvdb::math::TVD_RK1
         : order == 2 ? openvdb::math::TVD_RK2
                      : openvdb::math::TVD_RK3;
}

/// A velocity field as LevelSetAdvection asks for it: by node, in cells, with the time since
/// `start` in single precision. That is taken at the start of a sub-step; `start` makes up for it.
class NodeVelocity {
 public:
  using VectorType = openvdb::Vec3f;
  NodeVelocity(const GridVelocity& u, double start) : u_(u), start_(start) {}

  const openvdb::math::Transform& transform() const { return transform_; }
  VectorType operator()(const openvdb::Coord& node, float time) const {
    return at(Point(node[0], node[1], node[2]), time);
  }
  VectorType operator()(const openvdb::Vec3d& p, float time) const {
    return at(Point(p[0], p[1], p[2]), time);
  }

 private:
  VectorType at(const Point& p, float time) const {
    const Point v = u_(p, start_ + static_cast<double>(time));
    const VectorType single(static_cast<float>(v[0]), static_cast<float>(v[1]),
                            static_cast<float>(v[2]));
    if (!single.isFinite())
      throw InvalidInput("the velocity at a node near the surface is not finite; check the field");
    return single;
  }

  GridVelocity u_;
  double start_;
  openvdb::math::Transform transform_ = *openvdb::math::Transform::createLinearTransform(1.0);
};

}  // namespace

double courant_number(int time_order) {
  return (time_order == 1 ? 0.3 : time_order == 2 ? 0.9 : 1.0) / std::sqrt(3.0);  // the library's
}

void advect_upwind(openvdb::FloatGrid& grid, const GridVelocity& u, const UpwindStep& step,
                   const LevelSetOptions& o) {
  // The library widens the band after it moved, and drops at once what re-normalisation does not
  // bring below the border; so without it the surface would run out of its band.
  if (o.renormalise.every != 1)
    openvdb::tools::dilateActiveValues(grid.tree(), 1, openvdb::tools::NN_FACE_EDGE_VERTEX,
                                       openvdb::tools::IGNORE_TILES);
  const NodeVelocity field(u, step.time + step.dt / 2);
  openvdb::tools::LevelSetAdvection<openvdb::FloatGrid, NodeVelocity> advection(grid, field);
  advection.setSpatialScheme(scheme(o.scheme));
  advection.setTemporalScheme(integration(o.time_order));
  advection.setTrackerSpatialScheme(scheme(o.renormalise.scheme));
  advection.setTrackerTemporalScheme(integration(o.renormalise.time_order));
  advection.setNormCount(step.renormalise ? o.renormalise.steps : 0);
  advection.advect(0, static_cast<float>(step.dt));
}

void renormalise(openvdb::FloatGrid& grid, const Renormalisation& o) {
  openvdb::tools::LevelSetTracker<openvdb::FloatGrid> tracker(grid);
  tracker.setState({scheme(o.scheme), integration(o.time_order), o.steps, 1});
  tracker.track();
}

double fastest(const openvdb::FloatGrid& grid, const GridVelocity& u, double time) {
  openvdb::tree::LeafManager<const openvdb::FloatTree> leaves(grid.tree());
  const auto fastest_of = [&](std::size_t leaf) {
    double most = 0;
    for (auto at = leaves.leaf(leaf).cbeginValueOn(); at; ++at) {
      const openvdb::Coord node = at.getCoord();
      if (((node[0] | node[1] | node[2]) & 1) != 0) continue;
      most = std::max(most, u(Point(node[0], node[1], node[2]), time).norm());
    }
    return most;
  };
  return parallel_max(leaves.leafCount(), 0, fastest_of, 1);
}

}  // namespace suture::sims
