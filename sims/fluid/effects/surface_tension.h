// Surface tension: the mean curvature of the tracked surface, and the pressure jump it makes at
// the faces of the physics grid that the surface crosses.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "kernel/measure/nearest_triangle.h"
#include "kernel/triangles.h"
#include "sims/fluid/effects/effect.h"
#include "sims/fluid/effects/tension/curvature.h"

namespace suture::sims {

/// A surface with its mean curvature, a value a vertex, and a search tree of its triangles.
struct CurvedSurface {
  const Triangles& surface;
  const NearestTriangle& nearest;
  const std::vector<double>& curvature;
};

/// The pressure in the liquid minus that of the air, σκ, by axis and face; 0 at faces that do not
/// part a cell inside from one outside. κ is that of the triangle at the place where the surface
/// crosses the way between the two centres [Wojtan and Turk 2008], linear over it.
std::array<std::vector<double>, 3> tension_jump(const CurvedSurface& curved, const Liquid& liquid,
                                                double tension);

/// A liquid's tension on a grid.
struct TensionOptions {
  double tension = 0;  ///< force per length
  double density = 1;
  double h = 1;  ///< a cell's side
};

/// The longest time step at which the shortest capillary wave that the grid carries goes no
/// further than half a cell: √(ρh³/(4πσ)) [Brackbill et al. 1992], air having no weight.
/// Tension is explicit: who takes longer steps must take several. Infinite where tension is 0.
/// \throw InvalidInput unless h and density are finite and positive and tension is not negative
double capillary_step(const TensionOptions& options);

/// The part of the tension that a step dt holds stable: 1 up to the capillary step, and beyond it
/// what makes dt that step. All of it would make waves that grow until the liquid is torn apart.
/// \throw InvalidInput as capillary_step, or unless dt is positive
double stable_part(const TensionOptions& options, double dt);

/// The part of what ripples() gives that is taken in a capillary step. Without it an oscillating
/// drop of five cells' radius in edges of a cell has its ripples grow in some ten periods until
/// they are faster than the drop; with a tenth they go. In edges of 0.7 cells its swing loses 0.2 %
/// more a period.
inline constexpr double kRippleRate = 0.1;

/// The velocity of each vertex that takes the ripples out of the surface that it has within a cell,
/// which the grid does not see and tension would have taken out. To be added to the flow's where it
/// moves the surface (SurfaceVelocity). \throw InvalidInput as mean_curvature and capillary_step
Filtered<Point> ripple_velocity(const Triangles& surface, const TensionOptions& options,
                                CurvatureOptions curvature = {});

/// \pre the options are in the ranges of their tables
std::unique_ptr<Effect> make_surface_tension(const TensionOptions& options,
                                             const ModuleAccount& account);

}  // namespace suture::sims
