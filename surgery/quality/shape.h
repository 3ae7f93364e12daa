// The shapes of triangles and stars: extents, angles, normals [§6.2].
#pragma once

#include "surgery/collapse/features.h"

namespace suture::surgery {

/// Extent and shape of a triangle, all that decides whether it is bad.
struct Shape {
  double smallest_sine = 0;       ///< of its smallest angle; 0 without area
  double largest_cosine = -1;     ///< of its largest angle; -1 without area
  int longest = 0, shortest = 0;  ///< edges, from corner i to i + 1
};
Shape shape_of(const Corners& t);
Shape shape_of(const Mesh& mesh, Mesh::Face_index f);

/// The halfedge of `f` from its corner i to i + 1, corners as corners() gives them.
Mesh::Halfedge_index halfedge_of(const Mesh& mesh, Mesh::Face_index f, int i);

/// The smallest sine of any angle of the triangles before, or after.
double worst_before(const LocalChange& change);
double worst_after(const LocalChange& change);

double length_of(const Mesh& mesh, Mesh::Halfedge_index h);

/// Unit normal at a vertex from the triangles of its star, weighted so that it is exact on a
/// sphere, however irregular the star [Max 1999]; not finite where no triangle has an area.
Point vertex_normal(const Mesh& mesh, Mesh::Vertex_index v);

}  // namespace suture::surgery
