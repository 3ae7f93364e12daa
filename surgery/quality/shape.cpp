// Angles by their sines and cosines, from an area and three lengths [§6.2].
#include "surgery/quality/shape.h"

#include <algorithm>
#include <cmath>

namespace suture::surgery {

Shape shape_of(const Corners& t) {
  Shape shape;
  std::array<double, 3> squared;
  for (std::size_t i = 0; i < 3; ++i) squared[i] = (t[(i + 1) % 3] - t[i]).squaredNorm();
  for (int i = 1; i < 3; ++i) {
    if (squared[i] > squared[shape.longest]) shape.longest = i;
    if (squared[i] < squared[shape.shortest]) shape.shortest = i;
  }
  if (shape.longest == shape.shortest) shape.shortest = (shape.longest + 1) % 3;
  const double longest = squared[shape.longest], shortest = squared[shape.shortest];
  const double middle = squared[3 - shape.longest - shape.shortest];
  if (!(shortest > 0)) return shape;
  shape.smallest_sine = area_vector(t).norm() / (std::sqrt(longest) * std::sqrt(middle));
  shape.largest_cosine =
      (shortest + middle - longest) / (2 * std::sqrt(shortest) * std::sqrt(middle));
  return shape;
}

Shape shape_of(const Mesh& mesh, Mesh::Face_index f) { return shape_of(corners(mesh, f)); }

Mesh::Halfedge_index halfedge_of(const Mesh& mesh, Mesh::Face_index f, int i) {
  auto h = mesh.halfedge(f);
  for (; i > 0; --i) h = mesh.next(h);
  return h;
}

double worst_before(const LocalChange& change) {
  double worst = 1;
  for (const auto& t : change.triangles) worst = std::min(worst, shape_of(t.before).smallest_sine);
  return worst;
}

double worst_after(const LocalChange& change) {
  double worst = 1;
  for (const auto& t : change.triangles) worst = std::min(worst, shape_of(t.after).smallest_sine);
  return worst;
}

double length_of(const Mesh& mesh, Mesh::Halfedge_index h) {
  return (to_point(mesh.point(mesh.target(h))) - to_point(mesh.point(mesh.source(h)))).norm();
}

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
