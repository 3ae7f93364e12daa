// Euler::remove_face and add_face change the mesh in place; each vertex is found by its site.
#include "surgery/operate/stitch.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include "kernel/errors.h"

namespace suture::surgery {

Sewing::Sewing(Mesh& mesh, const Sites& sites, Origins& origins)
    : mesh_(mesh), sites_(sites), origins_(origins) {
  // Recycling would hand a new vertex the index of a removed one, which a site may still name.
  mesh_.set_recycle_garbage(false);
}

void Sewing::remove(const std::vector<std::uint32_t>& triangles) {
  for (const std::uint32_t t : triangles)
    CGAL::Euler::remove_face(mesh_.halfedge(Mesh::Face_index(t)), mesh_);
}

Mesh::Vertex_index Sewing::make(const Site& site) {
  const Mesh::Vertex_index old(site.source);
  if (site.kind == SiteKind::corner && !mesh_.is_removed(old)) return old;
  const auto v = mesh_.add_vertex(to_cgal(site.position));
  origins_.vertex[v] = site.kind == SiteKind::corner ? site.source : kNone;
  if (site.kind == SiteKind::type1) made_.type1.push_back(v);
  // Straightening would take the others off the edge that they are on, and cut its corners.
  if (site.kind == SiteKind::type2 && sites_.at_boundary(site)) made_.type2.push_back(v);
  if (site.kind == SiteKind::isosurface) made_.isosurface.push_back(v);
  return v;
}

std::vector<Mesh::Face_index> Sewing::add(
    std::initializer_list<const std::vector<Triangle>*> groups) {
  std::vector<char> used(sites_.all().size(), 0);  // other sites were asked for on the way only
  for (const auto* triangles : groups)
    for (const Triangle& t : *triangles)
      for (const std::uint32_t site : t) used[site] = 1;
  vertex_.resize(used.size(), Mesh::null_vertex());
  for (std::size_t s = 0; s < used.size(); ++s)
    if (used[s] != 0 && vertex_[s] == Mesh::null_vertex()) vertex_[s] = make(sites_.all()[s]);
  std::vector<Mesh::Face_index> faces;
  for (const auto* triangles : groups)
    for (const Triangle& t : *triangles) {
      faces.push_back(mesh_.add_face(vertex_[t[0]], vertex_[t[1]], vertex_[t[2]]));
      if (faces.back() == Mesh::null_face())
        throw InternalFailure("stitch", "a triangle would make the mesh non-manifold");
    }
  return faces;
}

}  // namespace suture::surgery
