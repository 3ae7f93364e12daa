// The normal at a vertex, from the triangles of its star.
#include "surgery/quality/vertex_normal.h"

#include <Eigen/Geometry>

namespace suture::surgery {

Point vertex_normal(const Mesh& mesh, Mesh::Vertex_index v) {
  Point sum = Point::Zero();
  const Point at = to_point(mesh.point(v));
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    const Point a = to_point(mesh.point(mesh.target(mesh.next(h)))) - at;
    const Point b = to_point(mesh.point(mesh.source(h))) - at;
    const double weight = a.squaredNorm() * b.squaredNorm();
    if (weight > 0) sum += a.cross(b) / weight;
  }
  return sum.normalized();
}

}  // namespace suture::surgery
