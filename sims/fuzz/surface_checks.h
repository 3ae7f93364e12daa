// Checks that look at one surface, or at the surfaces before and after one remodel. Each says in
// its source what is promised and why. Where the promise does not apply it objects to nothing.
#pragma once

#include "kernel/lattice.h"
#include "sims/fuzz/observation.h"

namespace suture::sims {

Objection check_audit(const Observation& o);
Objection check_bits(const Observation& o);
Objection check_map(const Observation& o);
Objection check_marches(const Observation& o);
Objection check_invariance(const Observation& o);
Objection check_settled(const Observation& o);
Objection check_solid_angle(const Observation& o);

/// A node of a lattice, and how often the surface is said to wind round it.
struct NodeWinding {
  Index3 node;
  int winding;
};

/// Whether the solid angle at a node is 4π times its winding. \pre the node is not near the surface
Objection compare_winding(const Triangles& surface, const Lattice& lattice,
                          const NodeWinding& claim);

}  // namespace suture::sims
