// Bodies of liquid on the physics grid, for the tests of the fluid.
#pragma once

#include <functional>
#include <memory>

#include "kernel/measure/signed_distance.h"
#include "kernel/shapes/shapes.h"
#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/liquid/liquid.h"
#include "sims/fluid/solids/solids.h"
#include "sims/fluid/velocity/pressure.h"

namespace suture {

using namespace suture::sims;

inline Triangles ball(const Point& centre, double radius, double edge_length) {
  SphereParameters p;
  p.centre = centre;
  p.radius = radius;
  p.edge_length = edge_length;
  return sphere(p);
}

/// A box of liquid of two triangles a side.
inline Triangles block_of_liquid(const Point& low, const Point& high) {
  BoxParameters p;
  p.centre = (low + high) / 2;
  p.size = high - low;
  p.edge_length = 10 * p.size.maxCoeff();
  Triangles made = box(p);
  for (Point& q : made.positions)  // to the last bit, which the middle and the size have not
    for (int a = 0; a < 3; ++a) q[a] = q[a] < p.centre[a] ? low[a] : high[a];
  return made;
}

/// Liquid with what it stands on. Kept where it is made: its parts point at each other.
struct LiquidScene {
  Triangles surface;
  SignedDistance exact;
  SampledSurface cells;
  Solids solids;
  Liquid liquid;
  const SparseGrid& grid;
  SolidFaces faces;

  LiquidScene(Triangles s, double h, Solids walls = {}, const Point& origin = Point::Zero(),
              int band = 3)
      : surface(std::move(s)),
        exact(surface),
        cells(sample_surface(surface, [this](const Point& p) { return exact.at(p); }, {origin, h})),
        solids(std::move(walls)),
        liquid(liquid_on(std::make_shared<const SparseGrid>(grid_round(cells, band)), cells,
                         surface, SolidsAt(solids, 0))),
        grid(*liquid.grid),
        faces(faces_of(solids, grid, 0)) {}
  LiquidScene(const LiquidScene&) = delete;
  LiquidScene& operator=(const LiquidScene&) = delete;

  ProjectionInput input(double dt = 1, double density = 1) const {
    return {liquid, faces, density, dt, nullptr, nullptr};
  }
  MacVelocity velocity(const std::function<Point(const Point&)>& field) const {
    MacVelocity v(liquid.grid);
    for (int a = 0; a < 3; ++a)
      for (Slot s = 0; s < grid.size(); ++s) v.u[a][s] = field(grid.face(grid.cell(s), a))[a];
    return v;
  }
  bool touches(int axis, Slot s) const {
    const Slot below = grid.neighbour(s, axis, -1);
    return below != kNoSlot && (liquid.inside(s) || liquid.inside(below));
  }
  /// The largest component on the open faces that touch liquid.
  double largest(const MacVelocity& v) const {
    double most = 0;
    for (int a = 0; a < 3; ++a)
      for (Slot s = 0; s < grid.size(); ++s)
        if (touches(a, s) && faces.open_at(a, s) > 0) most = std::max(most, std::abs(v.u[a][s]));
    return most;
  }
  /// The flow out of a cell, over h².
  double outflow(const MacVelocity& v, Slot s) const {
    double sum = 0;
    for (int a = 0; a < 3; ++a)
      for (const int side : {-1, 1}) {
        const Slot f = side < 0 ? s : grid.neighbour(s, a, 1);
        const double open = faces.open_at(a, f);
        sum += side * (open * v.u[a][f] + (1 - open) * faces.velocity_at(a, f));
      }
    return sum;
  }
  /// The root of the sum of its squares over the liquid's cells.
  double outflows(const MacVelocity& v) const {
    double sum = 0;
    for (Slot s = 0; s < grid.size(); ++s)
      if (liquid.inside(s)) sum += outflow(v, s) * outflow(v, s);
    return std::sqrt(sum);
  }
};

}  // namespace suture
