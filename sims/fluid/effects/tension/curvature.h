// The mean curvature of a mesh as the physics grid can carry it, and what it cannot.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/triangles.h"
#include "sims/fluid/linear/linear_system.h"

namespace suture::sims {

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

/// A value a vertex, and the solve of the filter that made it.
template <class Value>
struct Filtered {
  std::vector<Value> values;
  SolveReport solve;
};

/// κ₁ + κ₂ at each vertex, positive where the liquid bulges out, 2/R on a ball: the area's gradient
/// along the volume's by the area that is nearest to the vertex [Meyer et al. 2003], then filtered
/// over the surface. 0 at vertices that no free triangle has. At the contact line the gradients are
/// those of the free part and its mirror image in the solid.
/// \throw InvalidInput if h is not finite and positive, or on_solid has not a flag a vertex
Filtered<double> mean_curvature(const Triangles& surface, double h,
                                const CurvatureOptions& options = {});

/// Per vertex a displacement that takes ripples out of the surface which the grid does not carry:
/// along the normal, of a wave with s = (k·smoothing·h)² the part s³/(1 + s²)², a third at most.
/// Waves of many cells keep what they have, volume too but for what is of second order. 0 on
/// solids. \throw InvalidInput as mean_curvature
Filtered<Point> ripples(const Triangles& surface, double h, const CurvatureOptions& options = {});

}  // namespace suture::sims
