// Refuses a lattice too fine for the memory or the indices before anything is allocated.
#pragma once

#include "kernel/lattice.h"
#include "kernel/triangles.h"

namespace suture::surgery {

/// About how many crossings the surface has with the lattice: exact for mesh edges, by projected
/// area (in cells) for lattice lines. Linear, allocates nothing.
double expected_crossings(const Triangles& surface, const Lattice& lattice);

/// \throw InvalidInput if the crossings would outnumber 32-bit indices or not fit this machine's
/// memory, with both numbers and what to do
void require_crossings_fit(const Triangles& surface, const Lattice& lattice);

}  // namespace suture::surgery
