// Small closed surfaces for the tests of this floor, made without any shape library.
#pragma once

#include <map>
#include <utility>

#include "kernel/triangles.h"

namespace suture {

/// An octahedron with every triangle cut in four `times` over, pushed out to the sphere.
inline Triangles subdivided_ball(int times, double radius) {
  Triangles s{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int i = 0; i < times; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto next = static_cast<std::uint32_t>(s.positions.size());
      const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), next);
      if (fresh) s.positions.push_back((s.positions[a] + s.positions[b]).normalized());
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    s.triangles = std::move(finer);
  }
  for (Point& p : s.positions) p *= radius;
  return s;
}

/// `a`, and `b` moved by `shift`, as one surface of two components.
inline Triangles beside(Triangles a, const Triangles& b, const Point& shift) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  for (const Point& p : b.positions) a.positions.push_back(p + shift);
  for (const auto& [i, j, k] : b.triangles)
    a.triangles.push_back({i + first, j + first, k + first});
  return a;
}

}  // namespace suture
