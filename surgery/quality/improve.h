// Mesh improvement: subdivide, collapse, flip, within the rules [§6.2].
#pragma once

#include "kernel/mesh.h"
#include "surgery/model/options.h"
#include "surgery/model/report.h"
#include "surgery/model/tracker_lattice.h"

namespace suture::surgery {

/// Improves `mesh` in place until no edge is too long or short and no triangle is bad, or nothing
/// more is allowed, or options.passes have run. No node of `nodes` is swept; null: any may be. The
/// result is closed and manifold where the input is; garbage is collected, and the report maps old
/// vertices to new ones; its refused collapses are those of the last pass. Deterministic.
/// \throw InvalidInput unless options.edge_length is finite and above zero
QualityReport improve(Mesh& mesh, const QualityOptions& options,
                      const ShiftedLattice* nodes = nullptr);

}  // namespace suture::surgery
