// Surfaces snapped onto the nodes of a lattice of integers, where ties are everywhere.
#pragma once

#include "kernel/random.h"
#include "tests/surgery/support.h"

namespace suture {

/// Balls and tangles with coordinates 0 to 7: vertices on nodes, lines and planes, edges in lines,
/// triangles without area, vertices in one place.
inline Triangles snapped(std::uint64_t seed) {
  Random random(seed);
  Triangles body =
      ball(random.uniform(0.4, 3.4), Point::Constant(3.5), static_cast<int>(1 + seed % 3));
  const double reach = seed % 4 == 0 ? 3 : seed % 4 == 1 ? 0.8 : 0;
  for (Point& p : body.positions)
    for (int a = 0; a < 3; ++a)
      p[a] = std::clamp(std::round(p[a] + random.uniform(-reach, reach)), 0.0, 7.0);
  return body;
}

/// A surface's own edges and triangles, and their crossings.
struct Table {
  Incidence mesh;
  Crossings crossings;
};

inline Table table(const Triangles& surface, const Lattice& lattice, const Oracle& oracle) {
  Incidence mesh = incidence(surface);
  Crossings crossings = find_crossings(mesh, {lattice, oracle});
  return {std::move(mesh), std::move(crossings)};
}

inline Lattice integers() {
  std::vector<double> planes;
  for (int i = -4; i <= 12; ++i) planes.push_back(i);
  return Lattice({planes, planes, planes});
}

}  // namespace suture
