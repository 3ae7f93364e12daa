// Normal flow: every vertex moves along its own normal.
#include "sims/flows/normal_flow.h"

#include <Eigen/Geometry>

namespace suture::sims {

std::vector<Point> vertex_normals(const Triangles& surface) {
  const auto& x = surface.positions;
  std::vector<Point> normals(x.size(), Point::Zero());
  for (const auto& [a, b, c] : surface.triangles) {
    const Point n = (x[b] - x[a]).cross(x[c] - x[a]);
    for (const std::uint32_t v : {a, b, c}) normals[v] += n;
  }
  for (Point& n : normals) {
    const double length = n.norm();
    if (length > 0) n /= length;
  }
  return normals;
}

std::vector<Point> normal_flow(const Triangles& surface, double distance) {
  std::vector<Point> moved = vertex_normals(surface);
  for (std::size_t v = 0; v < moved.size(); ++v)
    moved[v] = surface.positions[v] + distance * moved[v];
  return moved;
}

}  // namespace suture::sims
