// The touched triangles leave the mesh; their kept parts and the patch are sewn in, by site [§6.1
// step 5].
#pragma once

#include <initializer_list>
#include <vector>

#include "surgery/model/surface.h"
#include "surgery/operate/sites.h"

namespace suture::surgery {

/// The vertices that sewing made, by kind; of type 2 those on the region's boundary.
struct StitchedVertices {
  std::vector<Mesh::Vertex_index> type1, type2, isosurface;
};

/// Takes triangles out of a mesh and sews triangles of sites in, in place; removed elements stay
/// uncollected. \pre faces and vertices of `mesh` are numbered as in the incidence that was cut
class Sewing {
 public:
  Sewing(Mesh& mesh, const Sites& sites, Origins& origins);

  void remove(const std::vector<std::uint32_t>& triangles);

  /// Adds vertices for the sites that some triangle of a group names and that have none yet, in the
  /// sites' order, then the triangles, group after group. \return the new faces
  /// \throw InternalFailure if one cannot be added; `mesh` is then to be thrown away
  std::vector<Mesh::Face_index> add(std::initializer_list<const std::vector<Triangle>*> groups);

  /// The vertex that stands for a site. \pre some triangle has named it
  Mesh::Vertex_index vertex(std::uint32_t site) const { return vertex_[site]; }
  const StitchedVertices& made() const { return made_; }
  Mesh& mesh() const { return mesh_; }
  const Sites& sites() const { return sites_; }

 private:
  Mesh::Vertex_index make(const Site& site);

  Mesh& mesh_;
  const Sites& sites_;
  Origins& origins_;
  std::vector<Mesh::Vertex_index> vertex_;
  StitchedVertices made_;
};

}  // namespace suture::surgery
