// The surface as the tracker keeps it: a mesh to operate on, and its exchange copy, numbered alike.
#pragma once

#include <vector>

#include "kernel/mesh.h"
#include "surgery/model/options.h"

namespace suture::surgery {

/// A mesh without garbage and its exchange copy, numbered alike.
struct Surface {
  Mesh mesh;
  Triangles triangles;
};

/// Old vertex and old triangle of each element, kept in step by CGAL while the mesh changes; kNone
/// for new ones.
struct Origins {
  Mesh::Property_map<Mesh::Vertex_index, std::uint32_t> vertex;
  Mesh::Property_map<Mesh::Face_index, std::uint32_t> triangle;
};

/// Attaches origins to a mesh: each element its own. \pre no garbage
Origins track_origins(Mesh& mesh);

/// A changed surface with the places of the old elements in it.
struct Adopted {
  Surface surface;
  std::vector<std::uint32_t> vertex_map;       ///< old vertex → new one or kNone; may end early
  std::vector<std::uint32_t> triangle_origin;  ///< new triangle → old one or kNone
};

/// Collects the garbage of `mesh`, takes its origins off it, and makes the exchange copy.
Adopted adopt(Mesh&& mesh, const Origins& origins);

/// Whether remodels of these options work on a jittered copy: the paper's remedy against
/// degeneracy, for plain doubles only [§5.3].
bool jitters(const TrackerOptions& options);

/// The surface with every coordinate moved by up to options.jitter cells, at random by each
/// vertex's number and coordinates: equal surfaces move alike, and others do not.
Surface jittered(Surface surface, const TrackerOptions& options);

}  // namespace suture::surgery
