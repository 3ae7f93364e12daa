// Normals for drawing: smooth across gentle edges, sharp across features, calm over slivers.
#include "sims/output/corner_normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace suture::sims {
namespace {

// Twice a sliver's area is below this share of its longest edge squared; its normal is mostly
// noise.
constexpr double kSliver = 0.05;

struct Face {
  Point area = Point::Zero();  ///< normal times twice the area
  Point unit = Point::Zero();  ///< zero for a sliver
};

std::vector<Face> faces_of(const Triangles& surface) {
  std::vector<Face> faces;
  const auto& x = surface.positions;
  for (const auto& [a, b, c] : surface.triangles) {
    Face face;
    face.area = (x[b] - x[a]).cross(x[c] - x[a]);
    const double longest = std::max(
        {(x[b] - x[a]).squaredNorm(), (x[c] - x[b]).squaredNorm(), (x[a] - x[c]).squaredNorm()});
    const double twice_area = face.area.norm();
    if (twice_area > kSliver * longest) face.unit = face.area / twice_area;
    faces.push_back(face);
  }
  return faces;
}

/// The triangles round each vertex: those of v are list[first[v]] to list[first[v + 1] - 1].
struct Stars {
  std::vector<std::uint32_t> first, list;
};

Stars stars_of(const Triangles& surface) {
  Stars stars;
  stars.first.assign(surface.positions.size() + 1, 0);
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t) ++stars.first[v + 1];
  for (std::size_t v = 1; v < stars.first.size(); ++v) stars.first[v] += stars.first[v - 1];
  stars.list.resize(3 * surface.triangles.size());
  std::vector<std::uint32_t> next = stars.first;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t v : surface.triangles[t]) stars.list[next[v]++] = t;
  return stars;
}

}  // namespace

std::vector<std::array<Point, 3>> corner_normals(const Triangles& surface, double feature_angle) {
  const double least = std::cos(feature_angle * std::numbers::pi / 180);
  const std::vector<Face> faces = faces_of(surface);
  const Stars stars = stars_of(surface);
  std::vector<std::array<Point, 3>> normals(surface.triangles.size());
  for (std::size_t t = 0; t < normals.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t v = surface.triangles[t][corner];
      const Point& own = faces[t].unit;
      Point sum = Point::Zero();
      for (std::uint32_t i = stars.first[v]; i < stars.first[v + 1]; ++i) {
        const Face& other = faces[stars.list[i]];
        if (own.isZero() || own.dot(other.unit) > least) sum += other.area;
      }
      const double length = sum.norm();
      normals[t][corner] = length > 0 ? Point(sum / length) : Point(Point::UnitZ());
    }
  return normals;
}

}  // namespace suture::sims
