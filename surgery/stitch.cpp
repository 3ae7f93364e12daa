// In place, with Euler::remove_face and add_face only; each vertex is found by its site's number.
#include "surgery/stitch.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include "kernel/errors.h"

namespace suture {

namespace {

/// Sites that some triangle names; the others were asked for on the way only.
std::vector<char> used_sites(const CutMesh& cut, const Patch& patch, const Sites& sites) {
  std::vector<char> used(sites.all().size(), 0);
  for (const auto* triangles : {&cut.kept, &patch.triangles})
    for (const Triangle& t : *triangles)
      for (const std::uint32_t site : t) used[site] = 1;
  return used;
}

std::vector<Mesh::Vertex_index> add_vertices(Mesh& mesh, const Sites& sites,
                                             const std::vector<char>& used, Origins& origins,
                                             StitchedVertices& made) {
  std::vector<Mesh::Vertex_index> vertex(sites.all().size());
  for (std::size_t s = 0; s < vertex.size(); ++s) {
    if (used[s] == 0) continue;
    const Site& site = sites.all()[s];
    const Mesh::Vertex_index old(site.source);
    if (site.kind == SiteKind::corner && !mesh.is_removed(old)) {
      vertex[s] = old;
      continue;
    }
    const auto v = mesh.add_vertex(to_cgal(site.position));
    origins.vertex[v] = site.kind == SiteKind::corner ? site.source : kNone;
    if (site.kind == SiteKind::type1) made.type1.push_back(v);
    // Straightening would take the others off the edge that they are on, and cut its corners.
    if (site.kind == SiteKind::type2 && sites.at_boundary(site)) made.type2.push_back(v);
    if (site.kind == SiteKind::isosurface) made.isosurface.push_back(v);
    vertex[s] = v;
  }
  return vertex;
}

void add_triangles(Mesh& mesh, const std::vector<Triangle>& triangles,
                   const std::vector<Mesh::Vertex_index>& vertex) {
  for (const Triangle& t : triangles) {
    const auto face = mesh.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]);
    if (face == Mesh::null_face())
      throw InternalFailure("stitch", "a triangle would make the mesh non-manifold");
  }
}

}  // namespace

StitchedVertices stitch(Mesh& mesh, const CutMesh& cut, const Patch& patch, const Sites& sites,
                        Origins& origins) {
  // Recycling would hand a new vertex the index of a removed one, which a site may still name.
  mesh.set_recycle_garbage(false);
  for (const std::uint32_t t : cut.touched)
    CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(t)), mesh);
  StitchedVertices made;
  const std::vector<Mesh::Vertex_index> vertex =
      add_vertices(mesh, sites, used_sites(cut, patch, sites), origins, made);
  add_triangles(mesh, cut.kept, vertex);
  add_triangles(mesh, patch.triangles, vertex);
  return made;
}

}  // namespace suture
