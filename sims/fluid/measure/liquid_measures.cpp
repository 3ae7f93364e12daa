// The liquid's energy and momentum, and how fast and how free of divergence it flows.
#include "sims/fluid/measure/liquid_measures.h"

#include <algorithm>
#include <cmath>

#include "kernel/errors.h"
#include "sims/fluid/grid/cut_cube.h"

namespace suture::sims {
namespace {

/// A cell's six faces, the low one of each axis first.
struct Faces {
  std::array<std::array<double, 2>, 3> u{}, open{},
      solid{};  ///< solid: the velocity of what closes
  std::array<std::array<bool, 2>, 3> known{};
};

Faces faces_of_cell(const MacVelocity& velocity, const SolidFaces& solids, Slot s) {
  Faces faces;
  for (int a = 0; a < 3; ++a)
    for (int side = 0; side < 2; ++side) {
      const Slot face = side == 0 ? s : velocity.grid->neighbour(s, a, 1);
      if (face == kNoSlot) continue;
      faces.open[a][side] = solids.open_at(a, face);
      faces.solid[a][side] = solids.velocity_at(a, face);
      const bool closed = !(faces.open[a][side] > 0);
      faces.known[a][side] = closed || velocity.known[a][face] != 0;
      if (faces.known[a][side])
        faces.u[a][side] = closed ? solids.velocity_at(a, face) : velocity.u[a][face];
    }
  for (int a = 0; a < 3; ++a)
    for (const int side : {0, 1})
      if (!faces.known[a][side] && faces.known[a][1 - side])
        faces.u[a][side] = faces.u[a][1 - side];
  return faces;
}

/// The part of a cell that solids leave. A flat one that is square to an axis leaves the part that
/// it leaves of the faces along it; those on planes of the grid close faces and take nothing.
double open_part(const Faces& faces) {
  double most = 0;
  bool whole = true, any = false;
  for (const auto& open : faces.open) {
    most = std::max(most, (open[0] + open[1]) / 2);
    for (const double part : open) {
      whole = whole && (part == 0 || part == 1);
      any = any || part == 1;
    }
  }
  return whole && any ? 1 : most;
}

/// The part of a cell that is liquid, and by how much its centre of mass is off the cell's.
struct Part {
  double volume = 0;  ///< of the cell
  Point offset = Point::Zero();
};

Part liquid_part(const Liquid& liquid, Slot s) {
  const SparseGrid& grid = *liquid.grid;
  const double h = grid.h(), d = liquid.distance[s] / h;
  if (std::abs(d) >= 0.8660254037844387) return {d < 0 ? 1.0 : 0.0};  // half a diagonal
  Point slope;
  for (int a = 0; a < 3; ++a) {
    const Slot low = grid.neighbour(s, a, -1), high = grid.neighbour(s, a, 1);
    const double below = low == kNoSlot ? liquid.distance[s] : liquid.distance[low];
    const double above = high == kNoSlot ? liquid.distance[s] : liquid.distance[high];
    slope[a] = above - below;
  }
  const double length = slope.norm();
  if (!(length > 0)) return {d < 0 ? 1.0 : 0.0};
  const Point normal = slope / length;
  const CutCube cut = cut_cube(normal, -d);
  return {cut.volume, h * cut.offset * normal};
}

/// The mass in a cell, and its centre.
struct CellMass {
  double mass = 0;
  Point at = Point::Zero();
};

void add_cell(const Faces& faces, const CellMass& cell, LiquidMeasures& sum) {
  Point u;
  double squares = 0;
  for (int a = 0; a < 3; ++a) {
    u[a] = (faces.u[a][0] + faces.u[a][1]) / 2;
    squares += (faces.u[a][0] * faces.u[a][0] + faces.u[a][1] * faces.u[a][1]) / 2;
  }
  sum.kinetic_energy += cell.mass * squares / 2;
  sum.momentum += cell.mass * u;
  sum.angular_momentum += cell.mass * cell.at.cross(u);
}

/// The flow out of a cell, over h²: the velocity through what is open of the faces, and the
/// solid's through the rest.
double outflow(const Faces& faces) {
  double flow = 0;
  for (int a = 0; a < 3; ++a)
    for (const int side : {0, 1}) {
      const double open = faces.open[a][side];
      flow += (side == 0 ? -1 : 1) * (open * faces.u[a][side] + (1 - open) * faces.solid[a][side]);
    }
  return flow;
}

}  // namespace

LiquidMeasures measure_liquid(const MacVelocity& velocity, const FlowDomain& domain,
                              const LiquidProperties& properties) {
  const auto& [density, gravity, wanted] = properties;
  if (!(density > 0) || !std::isfinite(density))
    throw InvalidInput("the liquid's density is " + number(density) +
                       "; it must be finite and positive");
  const auto& [liquid, solids] = domain;
  const SparseGrid& grid = *liquid.grid;
  const double cell = grid.h() * grid.h() * grid.h();
  LiquidMeasures sum;
  for (Slot s = 0; s < grid.size(); ++s) {
    Part part = liquid_part(liquid, s);
    if (!(part.volume > 0)) continue;
    const Faces faces = faces_of_cell(velocity, solids, s);
    const double open = open_part(faces);
    if (!(open > 0)) continue;
    part.volume *= open * cell;
    sum.volume += part.volume;
    const CellMass mass{density * part.volume, grid.centre(grid.cell(s)) + part.offset};
    add_cell(faces, mass, sum);
    sum.potential_energy -= mass.mass * gravity.dot(mass.at);
    if (!liquid.inside(s)) continue;
    Point u;
    for (int a = 0; a < 3; ++a) u[a] = (faces.u[a][0] + faces.u[a][1]) / 2;
    sum.largest_velocity = std::max(sum.largest_velocity, u.norm());
    const double rest = outflow(faces) / grid.h() - (wanted == nullptr ? 0 : (*wanted)[s]);
    sum.largest_divergence = std::max(sum.largest_divergence, std::abs(rest));
  }
  return sum;
}

}  // namespace suture::sims
