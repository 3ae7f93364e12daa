// An estimate in cells: doubles, so that it cannot itself overflow.
#include "surgery/detect/budget.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "kernel/errors.h"

namespace suture::surgery {

double expected_crossings(const Triangles& surface, const Lattice& lattice) {
  Point per_unit;
  for (int a = 0; a < 3; ++a)
    per_unit[a] = lattice.cells(a) / (lattice.plane(a, lattice.cells(a)) - lattice.plane(a, 0));
  auto cell = [&](std::uint32_t v) -> Point { return surface.positions[v].cwiseProduct(per_unit); };
  double edges = 0, lines = 0;
  for (const Triangle& t : surface.triangles) {
    const Point a = cell(t[0]), b = cell(t[1]), c = cell(t[2]);
    edges += ((b - a).lpNorm<1>() + (c - b).lpNorm<1>() + (a - c).lpNorm<1>()) / 2;
    lines += (b - a).cross(c - a).lpNorm<1>() / 2;
  }
  return edges + lines;
}

void require_crossings_fit(const Triangles& surface, const Lattice& lattice) {
  // Crossings, windings, cells and cut together: 120 to 180 bytes measured on bodies of 10⁵ to 10⁷.
  constexpr double kBytesEach = 200;
  constexpr double kMostIndices = 4294967295.0;
  const double count = expected_crossings(surface, lattice);
  const double memory =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (count < kMostIndices && count * kBytesEach < memory) return;
  char text[256];
  std::snprintf(
      text, sizeof text,
      "the surface would cross this lattice about %.3g times, which takes %.3g GB; this "
      "machine has %.3g GB, and at most %.3g crossings can be numbered; choose a larger cell",
      count, count * kBytesEach / 1e9, memory / 1e9, kMostIndices);
  throw InvalidInput(text);
}

}  // namespace suture::surgery
