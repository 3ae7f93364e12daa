// One remodel as a transaction: detect, cut, fill, stitch on a copy, audit, and only then commit.
#pragma once

#include "kernel/mesh.h"
#include "kernel/trace.h"
#include "surgery/options.h"
#include "surgery/report.h"

namespace suture {

/// A mesh and its exchange copy, numbered alike.
struct Surface {
  Mesh mesh;
  Triangles triangles;
};

/// Remodels `surface` in place, or leaves it untouched to the last bit and says why in the report.
/// \pre closed manifold, finite, without garbage
/// \throw InvalidInput if the lattice would not fit the indices or the memory
SurgeryReport remodel(Surface& surface, const TrackerOptions& options, const Oracle& oracle,
                      Trace* trace);

/// Exchanges mesh and copy for those of `mesh` with its garbage collected.
/// \return old vertex → new vertex, from the origins
std::vector<std::uint32_t> adopt(
    Surface& surface, Mesh&& mesh,
    const Mesh::Property_map<Mesh::Vertex_index, std::uint32_t>& origin);

}  // namespace suture
