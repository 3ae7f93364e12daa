// The exchange type: an indexed triangle surface, free of CGAL.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross products
#include <array>
#include <cstdint>
#include <vector>

namespace suture {

/// A point or vector in the scene's own unit of length.
using Point = Eigen::Vector3d;

/// Three vertex indices, counter-clockwise seen from outside the material.
using Triangle = std::array<std::uint32_t, 3>;

/// "No such vertex, edge or triangle".
inline constexpr std::uint32_t kNone = 0xffffffffU;

/// An indexed triangle surface. Nothing is promised of it: `require_closed_manifold` checks.
struct Triangles {
  std::vector<Point> positions;
  std::vector<Triangle> triangles;

  bool operator==(const Triangles&) const = default;
};

}  // namespace suture
