// Conversions between Surface_mesh and the exchange type.
#include "kernel/mesh.h"

#include "kernel/errors.h"

namespace suture {

Mesh to_mesh(const Triangles& surface) {
  Mesh mesh;
  const auto n = static_cast<Mesh::size_type>(surface.positions.size());
  const auto f = static_cast<Mesh::size_type>(surface.triangles.size());
  mesh.reserve(n, f + f / 2, f);
  for (const Point& p : surface.positions) mesh.add_vertex(to_cgal(p));
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    const auto face =
        mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
    if (face == Mesh::null_face())
      throw InternalFailure("to_mesh",
                            "triangle " + std::to_string(i) + " makes the mesh non-manifold");
  }
  return mesh;
}

Triangles to_triangles(const Mesh& mesh) {
  Triangles surface;
  surface.positions.reserve(mesh.number_of_vertices());
  surface.triangles.reserve(mesh.number_of_faces());
  std::vector<std::uint32_t> index(mesh.num_vertices(), kNone);
  for (const auto v : mesh.vertices()) {
    index[v] = static_cast<std::uint32_t>(surface.positions.size());
    surface.positions.push_back(to_point(mesh.point(v)));
  }
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);  // add_face leaves it pointing at the first vertex given
    surface.triangles.push_back(
        {index[mesh.target(h)], index[mesh.target(mesh.next(h))], index[mesh.source(h)]});
  }
  return surface;
}

}  // namespace suture
