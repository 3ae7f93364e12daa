// Surface tension: the mean curvature of the tracked surface, and the pressure jump it makes at
// the faces of the physics grid that the surface crosses.
#pragma once

#include <array>
#include <vector>

#include "kernel/measure/nearest_triangle.h"
#include "kernel/triangles.h"
#include "sims/fluid/effects/tension/curvature.h"
#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {

/// The pressure in the liquid minus that of the air, σκ, by axis and face; 0 at faces that do not
/// part a cell inside from one outside. κ is that of the triangle at the place where the surface
/// crosses the way between the two centres [Wojtan and Turk 2008], linear over it.
/// \pre `nearest` is of `surface`, `curvature` has a value a vertex
std::array<std::vector<double>, 3> tension_jump(const Triangles& surface,
                                                const NearestTriangle& nearest,
                                                const std::vector<double>& curvature,
                                                const Liquid& liquid, double tension);

/// The longest time step at which the shortest capillary wave that the grid carries goes no
/// further than half a cell: √(ρh³/(4πσ)) [Brackbill et al. 1992], air having no weight.
/// Tension is explicit: who takes longer steps must take several. Infinite where tension is 0.
/// \throw InvalidInput unless h and density are finite and positive and tension is not negative
double capillary_step(double h, double density, double tension);

/// The share of the tension that a step dt holds stable: 1 up to the capillary step, and beyond it
/// what makes dt that step. All of it would make waves that grow until the liquid is torn apart.
/// \throw InvalidInput as capillary_step, or unless dt is positive
double stable_share(double dt, double h, double density, double tension);

/// × what ripples() gives, a capillary step. Without it an oscillating drop of five cells' radius
/// in edges of a cell has its ripples grow in some ten periods until they are faster than the drop;
/// with a tenth they go. In edges of 0.7 cells its swing loses 0.2 % more a period.
inline constexpr double kRippleRate = 0.1;

/// Of each vertex, what takes the ripples out of the surface that it has within a cell, which the
/// grid does not see and tension would have taken out. To be added to the flow's where it moves the
/// surface (SurfaceVelocity). \throw InvalidInput as mean_curvature and capillary_step
std::vector<Point> ripple_velocity(const Triangles& surface, double h, double density,
                                   double tension, CurvatureOptions options = {});

}  // namespace suture::sims
