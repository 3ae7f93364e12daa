// The connected parts of the liquid: drops and pools, each with the bubbles that are in it.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/measure/nearest_triangle.h"
#include "kernel/triangles.h"
#include "sims/fluid/liquid/liquid.h"

namespace suture::sims {

/// A body is a component of the surface that bounds liquid from outside, with all components that
/// bound cavities in it. Numbered in order of first appearance.
struct LiquidBodies {
  std::vector<std::uint32_t> of_triangle;
  std::size_t count = 0;
};

/// A component of negative volume belongs to the smallest one of positive volume that goes round
/// it; where none does (a surface that still passes through itself), to the smallest whose box
/// holds its own, and where there is none it is a body of its own. \pre closed, oriented outwards
LiquidBodies liquid_bodies(const Triangles& surface);

/// Volumes and areas by body, exact to rounding; a volume may be negative where the surface is
/// inside-out.
struct BodyMeasures {
  std::vector<double> volume, area;
};

/// \pre `bodies` are those of a surface of the same triangles
BodyMeasures measure(const Triangles& surface, const LiquidBodies& bodies);

/// The body of each cell inside the liquid, kNone elsewhere: at the surface that of the triangle
/// which is crossed, deeper that of the nearest such cell from cell to cell.
/// \pre `nearest` and `liquid` are of `surface`
std::vector<std::uint32_t> bodies_of_cells(const LiquidBodies& bodies,
                                           const NearestTriangle& nearest, const Liquid& liquid);

}  // namespace suture::sims
