// The exchange type: an indexed triangle surface, free of CGAL.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross products
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace suture {

/// A point or vector in the scene's own unit of length.
using Point = Eigen::Vector3d;

/// Three vertex indices, counter-clockwise seen from outside the material.
using Triangle = std::array<std::uint32_t, 3>;

/// The index that stands for "there is no such vertex, edge or triangle".
inline constexpr std::uint32_t kNone = 0xffffffffU;

/// An indexed triangle surface. Nothing is promised of it: `require_closed_manifold` checks.
struct Triangles {
  std::vector<Point> positions;
  std::vector<Triangle> triangles;

  bool operator==(const Triangles&) const = default;
};

/// Whether the two are equal to the last bit: −0 is not 0, and a NaN is itself.
inline bool same_bits(const Triangles& a, const Triangles& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return a.triangles == b.triangles &&
         std::equal(a.positions.begin(), a.positions.end(), b.positions.begin(), b.positions.end(),
                    [&](const Point& p, const Point& q) {
                      return bits(p[0]) == bits(q[0]) && bits(p[1]) == bits(q[1]) &&
                             bits(p[2]) == bits(q[2]);
                    });
}

}  // namespace suture
