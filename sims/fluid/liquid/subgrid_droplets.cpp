// Drops without a cell's centre: no pressure carries them, so at a solid they move as one.
#include "sims/fluid/liquid/subgrid_droplets.h"

#include <algorithm>

#include "sims/fluid/solids/wall_projection.h"

namespace suture::sims {
namespace {

/// Cells: how near to a solid what it does to the velocity at a wall is felt (constrain).
constexpr double kAtSolid = 1.5;

/// Gives the known faces of a drop's cells its velocity, but for those of other liquid's cells.
void hold(MacVelocity& velocity, const Liquid& liquid, const Drop& drop, const Point& v) {
  const SparseGrid& grid = *velocity.grid;
  for (const Index3& cell : drop.cells) {
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

DropsAtSolids::DropsAtSolids(const std::vector<Drop>& drops, const Triangles& surface,
                             const Liquid& liquid, const Solids& solids, double t, double dt,
                             MacVelocity& velocity) {
  const double h = velocity.grid->h();
  for (const Drop& drop : drops) {
    std::vector<Point> body;
    Point mean = Point::Zero();
    for (const std::uint32_t v : drop.vertices) {
      body.push_back(surface.positions[v]);
      mean += velocity.at(body.back()) / static_cast<double>(drop.vertices.size());
    }
    const double reach = kAtSolid * h + (mean.norm() + solids.fastest()) * dt;
    if (std::none_of(body.begin(), body.end(),
                     [&](const Point& p) { return solids.distance(p, t) < reach; }))
      continue;
    const KeptBody way = kept_out(solids, body, mean, t, dt, h);
    if (way.squeezed) continue;
    hold(velocity, liquid, drop, way.velocity);
    for (std::size_t n = 0; n < body.size(); ++n)
      moved_.push_back({drop.vertices[n], body[n] + dt * way.velocity});
  }
}

void DropsAtSolids::put(std::vector<Point>& positions) const {
  for (const Vertex& v : moved_) positions[v.index] = v.to;
}

}  // namespace suture::sims
