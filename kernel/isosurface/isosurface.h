// The zero surface of a smooth function by marching tetrahedra: closed, manifold, embedded.
#pragma once

#include <functional>

#include "kernel/lattice.h"
#include "kernel/triangles.h"

namespace suture {

/// A function of space that is negative inside the material.
using ScalarField = std::function<double(const Point&)>;

/// The surface where `field` is zero, on cubes of side `cell` that are each cut into six tetrahedra
/// [Kuhn 1960]. Vertices lie on edges of the tetrahedra, at the zeros there, so that pieces of
/// different tetrahedra only ever meet in common edges. A node with the value 0 counts as outside.
/// \pre `field` is positive on and outside the box's border
/// \throw InvalidInput if it is not, or if the box takes 2³¹ nodes or more
Triangles isosurface(const ScalarField& field, const Box& box, double cell);

}  // namespace suture
