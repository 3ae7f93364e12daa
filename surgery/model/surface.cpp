// Garbage collection renumbers elements; origins tell what became of the old ones.
#include "surgery/model/surface.h"

#include <algorithm>

namespace suture::surgery {

Origins track_origins(Mesh& mesh) {
  Origins origins;
  origins.vertex =
      mesh.add_property_map<Mesh::Vertex_index, std::uint32_t>("v:origin", kNone).first;
  origins.triangle =
      mesh.add_property_map<Mesh::Face_index, std::uint32_t>("f:origin", kNone).first;
  for (const auto v : mesh.vertices()) origins.vertex[v] = v;
  for (const auto f : mesh.faces()) origins.triangle[f] = f;
  return origins;
}

Adopted adopt(Mesh&& mesh, const Origins& origins) {
  mesh.collect_garbage();
  Adopted result;
  for (const auto v : mesh.vertices()) {
    const std::uint32_t old = origins.vertex[v];
    if (old == kNone) continue;
    if (result.vertex_map.size() <= old) result.vertex_map.resize(old + 1, kNone);
    result.vertex_map[old] = v;
  }
  for (const auto f : mesh.faces()) result.triangle_origin.push_back(origins.triangle[f]);
  Origins own = origins;
  mesh.remove_property_map(own.vertex);
  mesh.remove_property_map(own.triangle);
  result.surface.triangles = to_triangles(mesh);
  result.surface.mesh = std::move(mesh);
  return result;
}

}  // namespace suture::surgery
