// Tiny surfaces for tests, built in code.
#pragma once

#include "kernel/random.h"
#include "kernel/triangles.h"

namespace suture {

inline Triangles tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

/// Twelve triangles round [low, high]³.
inline Triangles cube(double low, double high) {
  Triangles s;
  for (int i = 0; i < 8; ++i)
    s.positions.push_back({i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low});
  s.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return s;
}

/// n × n squares of an open height field, two triangles each, over the unit square.
inline Triangles sheet(std::uint32_t n, double height = 0) {
  Triangles s;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      s.positions.push_back({double(i) / n, double(j) / n, height});
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = j * (n + 1) + i;
      s.triangles.push_back({v, v + 1, v + n + 2});
      s.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  return s;
}

inline Triangles joined(Triangles a, const Triangles& b) {
  const auto shift = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

inline Triangles turned(Triangles s) {
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

inline Triangles stretched(Triangles s, double factor) {
  for (Point& p : s.positions) p *= factor;
  return s;
}

/// Every triangle with vertices of its own.
inline Triangles soup(const Triangles& s) {
  Triangles loose;
  for (const Triangle& t : s.triangles) {
    const auto v = static_cast<std::uint32_t>(loose.positions.size());
    for (const std::uint32_t i : t) loose.positions.push_back(s.positions[i]);
    loose.triangles.push_back({v, v + 1, v + 2});
  }
  return loose;
}

class Dice : public Random {
 public:
  using Random::Random;
  /// A number in [-1, 1).
  double signed_unit() { return static_cast<double>(next() >> 11) * 0x1p-52 - 1; }
};

}  // namespace suture
