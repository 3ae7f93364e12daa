// The touched triangles leave the mesh; their kept parts and the patch are sewn in, by site [§6.1
// step 5].
#pragma once

#include <vector>

#include "kernel/mesh.h"
#include "surgery/cut.h"
#include "surgery/fill.h"

namespace suture {

/// Vertices that a stitch made, by kind.
struct StitchedVertices {
  std::vector<Mesh::Vertex_index> type1, type2, isosurface;
};

/// Old vertex of each vertex: kept in step by CGAL while the mesh changes; kNone for new vertices.
using OriginMap = Mesh::Property_map<Mesh::Vertex_index, std::uint32_t>;

/// Replaces `cut.touched` by `cut.kept` and the patch, in place; removed elements stay uncollected.
/// \pre faces and vertices of `mesh` are numbered as in the incidence that was cut
/// \throw InternalFailure if a triangle cannot be added; `mesh` is then to be thrown away
StitchedVertices stitch(Mesh& mesh, const CutMesh& cut, const Patch& patch, const Sites& sites,
                        OriginMap& origin);

}  // namespace suture
