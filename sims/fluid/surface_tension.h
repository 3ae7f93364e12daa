// Surface tension: the mean curvature of the tracked surface, and the pressure jump it makes at
// the faces of the physics grid that the surface crosses.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/nearest_triangle.h"
#include "kernel/triangles.h"
#include "sims/fluid/liquid.h"

namespace suture {

/// The gradient of the surface's area by each vertex [Brochu 2006]: with a minus and times the
/// tension it is the force on the vertex. Over a closed surface the sum is zero to rounding; of a
/// vertex it is at most half the length of the edges round it, whatever slivers there are.
std::vector<Point> area_gradient(const Triangles& surface);

struct CurvatureOptions {
  /// × h: of a wave with wavenumber k curvature keeps 1/(1 + (k·smoothing·h)⁴), as Butterworth's
  /// filter. The grid takes waves shorter than two cells for longer ones: with much more left of
  /// them (smoothing 0.5) an oscillating drop gains energy until it bursts.
  double smoothing = 1;
  /// × 1/h: the most curvature. A ball as wide as a cell, the smallest that the grid knows, has
  /// 4/h; sharper things have what that has.
  double most = 4;
  /// A flag a vertex: it lies on a solid; null: none does. The part of the surface whose triangles
  /// have only such vertices is no free surface, and the rest meets it at 90°.
  const std::vector<std::uint8_t>* on_solid = nullptr;
};

/// κ₁ + κ₂ at each vertex, positive where the liquid bulges out, 2/R on a ball: the area's gradient
/// along the volume's by the area that is nearest to the vertex [Meyer et al. 2003], then filtered
/// over the surface. 0 at vertices that no free triangle has. At the contact line the gradients are
/// those of the free part and its mirror image in the solid.
/// \throw InvalidInput if h is not finite and positive, or on_solid has not a flag a vertex
std::vector<double> mean_curvature(const Triangles& surface, double h,
                                   const CurvatureOptions& options = {});

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

}  // namespace suture
