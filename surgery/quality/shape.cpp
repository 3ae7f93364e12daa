// Whether a triangle is bad, and what one split is [§6.2].
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>

#include "surgery/quality/passes.h"

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

bool is_bad(const Shape& shape, const Improvement& improvement) {
  return shape.smallest_sine < improvement.sin_smallest_angle ||
         shape.largest_cosine < improvement.cos_largest_angle;
}

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

Mesh::Vertex_index split_edge(Mesh& mesh, Mesh::Halfedge_index h, const Point& at) {
  const auto half = CGAL::Euler::split_edge(h, mesh);  // ends at the new vertex; h leaves it
  const auto v = mesh.target(half);
  mesh.point(v) = to_cgal(at);
  CGAL::Euler::split_face(half, mesh.next(h), mesh);
  CGAL::Euler::split_face(mesh.opposite(h), mesh.next(mesh.opposite(half)), mesh);
  return v;
}

LocalChange split_change(const Mesh& mesh, Mesh::Halfedge_index h, const Point& at) {
  LocalChange change;
  for (const auto g : {h, mesh.opposite(h)}) {
    const Point a = to_point(mesh.point(mesh.source(g))), b = to_point(mesh.point(mesh.target(g)));
    const Point c = to_point(mesh.point(mesh.target(mesh.next(g))));
    change.triangles.push_back({{a, b, c}, {a, at, c}});
    change.triangles.push_back({{a, b, c}, {at, b, c}});
    change.swept.push_back({a, b, c, at});
  }
  return change;
}

}  // namespace suture::surgery
