// The normal at a vertex, from the triangles of its star.
#pragma once

#include "kernel/mesh.h"

namespace suture::surgery {

/// Unit normal, weighted so that it is exact on a sphere, however irregular the star [Max 1999];
/// not finite where no triangle of the star has an area.
Point vertex_normal(const Mesh& mesh, Mesh::Vertex_index v);

}  // namespace suture::surgery
