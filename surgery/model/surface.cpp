// Garbage collection renumbers elements; origins tell what became of the old ones.
#include "surgery/model/surface.h"

#include <bit>

#include "kernel/random.h"

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

bool jitters(const TrackerOptions& options) {
  return options.arithmetic == Arithmetic::rounded && options.jitter > 0;
}

Surface jittered(Surface surface, const TrackerOptions& options) {
  // Seeds come from a hash of each vertex, so that no state is kept between remodels.
  const double reach = options.jitter * options.cell_size;
  for (std::uint32_t v = 0; v < surface.triangles.positions.size(); ++v) {
    Point& p = surface.triangles.positions[v];
    std::uint64_t seed = v;
    for (const double x : p) seed = Random(seed ^ std::bit_cast<std::uint64_t>(x)).next();
    Random random(seed);
    for (double& x : p) x += random.uniform(-reach, reach);
    surface.mesh.point(Mesh::Vertex_index(v)) = to_cgal(p);
  }
  return surface;
}

}  // namespace suture::surgery
