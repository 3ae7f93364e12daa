// The liquid's energy and momentum, and how fast and how free of divergence it flows.
#pragma once

#include <vector>

#include "sims/fluid/grid/mac_velocity.h"
#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {

/// Measures in the scene's units: sums over cells by the part of each that is liquid and no solid.
/// D is taken as a plane there, a solid as flat by what it leaves open of the faces. They are of
/// second order in h but at walls off the grid's planes: their parts of a cell are multiplied as if
/// they were independent, which counts too much (a volume of 1.161 for 1.003).
struct LiquidMeasures {
  double volume = 0;  ///< as the grid sees it; the surface's is exact
  double kinetic_energy = 0;
  double potential_energy = 0;  ///< 0 at the scene's origin
  Point momentum = Point::Zero();
  Point angular_momentum = Point::Zero();  ///< about the scene's origin
  double largest_velocity = 0;             ///< at centres of cells inside
  double largest_divergence = 0;           ///< beyond the wanted one, of cells inside, per time
};

/// The density and gravity that a measurement takes into account beside the flow.
struct LiquidProperties {
  double density = 1;
  Point gravity = Point::Zero();
  /// The divergence that is wanted in each cell, as in ProjectionInput. Null: none.
  const std::vector<double>* divergence = nullptr;
};

/// Faces that are not known count as the known one on the other side of the cell, closed ones as
/// the solid, and a cell with neither is at rest. \pre sizes fit the grid
/// \throw InvalidInput unless the density is finite and positive
LiquidMeasures measure_liquid(const MacVelocity& velocity, const FlowDomain& domain,
                              const LiquidProperties& properties);

}  // namespace suture::sims
