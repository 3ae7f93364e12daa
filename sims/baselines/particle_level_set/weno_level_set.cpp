// Dense level sets to OpenVDB's grids and back, round the library's own steps.
#include "sims/baselines/particle_level_set/weno_level_set.h"

#include <openvdb/tools/SignedFloodFill.h>

#include "kernel/errors.h"
#include "sims/baselines/level_set/upwind_advection.h"

namespace suture::sims {
namespace {

LevelSetOptions weno5_rk3(double width) {
  LevelSetOptions options;
  options.half_width = width;
  options.scheme = UpwindScheme::weno5;
  options.time_order = 3;
  options.renormalise.every = 0;
  return options;
}

openvdb::FloatGrid::Ptr sparse(const DenseLevelSet& set) {
  auto grid = openvdb::FloatGrid::create(static_cast<float>(set.width));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  auto values = grid->getAccessor();
  for (std::size_t n = 0; n < set.phi.size(); ++n) {
    if (std::abs(set.phi[n]) >= set.width) continue;
    const Index3 node = set.box.node(n);
    values.setValue({node[0], node[1], node[2]}, static_cast<float>(set.phi[n]));
  }
  openvdb::tools::signedFloodFill(grid->tree());
  return grid;
}

DenseLevelSet dense(const openvdb::FloatGrid& grid, double width, const Box& cover) {
  Box cells = cover;
  if (const auto band = grid.evalActiveVoxelBoundingBox(); !band.empty()) {
    const bool alone = (cover.low.array() > cover.high.array()).any();
    for (int a = 0; a < 3; ++a) {
      cells.low[a] = alone ? band.min()[a] : std::min<double>(cover.low[a], band.min()[a]);
      cells.high[a] = alone ? band.max()[a] : std::max<double>(cover.high[a], band.max()[a]);
    }
  }
  if ((cells.low.array() > cells.high.array()).any()) cells = {Point::Zero(), Point::Zero()};
  DenseLevelSet set{node_box(cells, 2), {}, width};
  set.phi.resize(set.box.count());
  auto values = grid.getConstAccessor();
  for (std::size_t n = 0; n < set.phi.size(); ++n) {
    const Index3 node = set.box.node(n);
    set.phi[n] = values.getValue({node[0], node[1], node[2]});
  }
  return set;
}

}  // namespace

DenseLevelSet weno_advected(const DenseLevelSet& old, const GridVelocity& u, const WenoStep& step) {
  constexpr double kSafety = 0.9;  // the fastest node is not always among those asked
  constexpr double kMostParts = 1e6;
  const LevelSetOptions options = weno5_rk3(old.width);
  const auto grid = sparse(old);
  const double speed =
      fastest(*grid, u, step.time) / (kSafety * courant_number(options.time_order));
  const double parts = std::max(1.0, std::ceil(step.dt * speed));
  if (!(parts < kMostParts))
    throw InvalidInput("level set: the velocity is not finite, or a step of " + number(step.dt) +
                       " takes more than a million sub-steps; take shorter steps");
  for (double part = 0; part < parts; ++part)
    advect_upwind(*grid, u, {step.time + part / parts * step.dt, step.dt / parts, false}, options);
  return dense(*grid, old.width, step.cover);
}

DenseLevelSet weno_relaxed(const DenseLevelSet& old, int steps, const Box& cover) {
  const auto grid = sparse(old);
  renormalise(*grid, {.every = 1, .scheme = UpwindScheme::weno5, .time_order = 3, .steps = steps});
  return dense(*grid, old.width, cover);
}

}  // namespace suture::sims
