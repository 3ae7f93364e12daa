// Bodies that are exact copies of one another: one of them will do, without re-sampling.
#pragma once

#include <vector>

#include "kernel/measure/measures.h"
#include "surgery/model/tracker_lattice.h"

namespace suture::surgery {

/// The triangles of every component that repeats an earlier one exactly (the same coordinates, the
/// same orientation, whatever the numbering), in increasing order. Linear where no two components
/// have the same number of triangles.
std::vector<std::uint32_t> repeated_triangles(const Triangles& surface,
                                              const Components& components);

/// Whether the side of every node of the lattice is the same with and without the repeated bodies,
/// so that they may be dropped. It is not where cavities or inverted parts tell the copies apart.
bool sides_agree(const Triangles& single, const Triangles& repeated, const ShiftedLattice& on);

}  // namespace suture::surgery
