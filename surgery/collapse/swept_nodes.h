// No node of the shifted lattice may lie in what the surface sweeps: no winding changes [§6.2].
#pragma once

#include <array>
#include <span>

#include "surgery/model/tracker_lattice.h"

namespace suture::surgery {

using Corners = std::array<Point, 3>;  ///< of a triangle
using Tetrahedron = std::array<Point, 4>;

/// Whether a node of the shifted lattice lies in the tetrahedron; false where it has no volume.
bool holds_node(const Tetrahedron& tetrahedron, const ShiftedLattice& on);

/// Whether one lies in any of the tetrahedra.
bool any_holds_node(std::span<const Tetrahedron> tetrahedra, const ShiftedLattice& on);

}  // namespace suture::surgery
