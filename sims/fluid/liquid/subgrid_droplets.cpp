// Droplets without a cell's centre: no pressure carries them, so at a solid they move as one.
#include "sims/fluid/liquid/subgrid_droplets.h"

#include <algorithm>

namespace suture::sims {
namespace {

/// Cells: how near to a solid what it does to the velocity at a wall is felt (constrain).
constexpr double kAtSolid = 1.5;

/// Gives the known faces of a droplet's cells its velocity, but for those of other liquid's cells.
void hold(MacVelocity& velocity, const Liquid& liquid, const std::vector<Index3>& cells,
          const Point& v) {
  const SparseGrid& grid = *velocity.grid;
  for (const Index3& cell : cells) {
    const Slot s = grid.find(cell);
    if (s == kNoSlot || liquid.inside(s)) continue;
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        const Slot other = grid.neighbour(s, axis, side);
        if (other == kNoSlot || liquid.inside(other)) continue;
        const Slot face = side < 0 ? s : other;
        if (velocity.known[axis][face] != 0) velocity.u[axis][face] = v[axis];
      }
  }
}

}  // namespace

DropletsAtSolids::DropletsAtSolids(const std::vector<SubgridDroplet>& droplets,
                                   const Triangles& surface, const WallProjection& walls,
                                   const Liquid& liquid, MacVelocity& velocity) {
  const SolidsAt solids(walls.solids, walls.t);
  for (const SubgridDroplet& droplet : droplets) {
    std::vector<Point> body;
    Point mean = Point::Zero();
    for (const std::uint32_t v : droplet.vertices) {
      body.push_back(surface.positions[v]);
      mean += velocity.at(body.back()) / static_cast<double>(droplet.vertices.size());
    }
    const double reach =
        kAtSolid * velocity.grid->h() + (mean.norm() + walls.solids.fastest()) * walls.dt;
    if (std::none_of(body.begin(), body.end(),
                     [&](const Point& p) { return solids.distance(p) < reach; }))
      continue;
    const BodyVelocity way = walls.of_body(body, mean);
    if (way.squeezed) continue;
    hold(velocity, liquid, droplet.cells, way.velocity);
    for (std::size_t n = 0; n < body.size(); ++n)
      moved_.push_back({droplet.vertices[n], body[n] + walls.dt * way.velocity});
  }
}

void DropletsAtSolids::put(std::vector<Point>& positions) const {
  for (const Vertex& v : moved_) positions[v.index] = v.to;
}

}  // namespace suture::sims
