// Steps towards smaller cases; each keeps a surface a closed oriented manifold.
#pragma once

#include "kernel/triangles.h"

namespace suture::sims {

/// The surface without the k-th of its components; the others keep their order.
Triangles without_component(const Triangles& surface, std::uint32_t k);

/// A component may give way to one of these: few triangles through some of its extreme points.
enum class Stand { tetrahedron, box };

/// The component replaced, where that has fewer triangles; else an empty surface.
Triangles component_replaced(const Triangles& surface, std::uint32_t k, Stand stand);

/// Collapses the edge from corner `k` of triangle `t` to the next onto the latter, unless the
/// result would be no closed manifold; the surface then stays. \return whether it did
bool collapse_edge(Triangles& surface, std::size_t t, std::size_t k);

/// The number with its mantissa rounded to so many bits. \pre bits >= 1
double rounded_to_bits(double x, int bits);

}  // namespace suture::sims
