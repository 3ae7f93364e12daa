// The zero surface of a smooth function by marching tetrahedra: closed, manifold, embedded.
#pragma once

#include <functional>

#include "kernel/lattice.h"
#include "kernel/triangles.h"

namespace suture {

/// Negative inside the material.
using ScalarField = std::function<double(const Point&)>;

/// The surface where `field` is zero, on cubes of side `cell` each cut into six tetrahedra (Kuhn).
/// A vertex lies on a tetrahedron's edge, at the zero there, so pieces of different tetrahedra
/// never meet but in common edges. A node with the value 0 counts as outside.
/// \pre `field` is positive on and outside the box's border
/// \throw InvalidInput if it is not, or the box takes more than 2³¹ nodes
Triangles isosurface(const ScalarField& field, const Box& box, double cell);

}  // namespace suture
