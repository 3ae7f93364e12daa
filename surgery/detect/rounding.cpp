// Most nodes near a surface are settled by the nearest triangle; long triangles have larger units.
#include "surgery/detect/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture::surgery {

namespace {

constexpr double kUnits = 4;

/// The distance from x ≥ 0 to the next double above it.
double unit_in_last_place(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
}

/// The largest coordinates, on each axis, of the cells round a node.
Point largest_near(const Index3& node, const Lattice& lattice) {
  Point largest;
  for (int a = 0; a < 3; ++a) {
    const int low = std::max(node[a] - 1, 0), high = std::min(node[a] + 1, lattice.cells(a));
    largest[a] = std::max(std::abs(lattice.plane(a, low)), std::abs(lattice.plane(a, high)));
  }
  return largest;
}

double reach_of(const Point& largest) {
  const Point units = largest.unaryExpr([](double x) { return unit_in_last_place(x); });
  return kUnits * std::hypot(units[0], units[1], units[2]);
}

}  // namespace

Rounding::Rounding(const Triangles& surface, const Lattice& lattice)
    : surface_(surface), lattice_(lattice), nearest_(surface) {}

bool Rounding::reaches(const Index3& node) const {
  const Point at = lattice_.node(node), near = largest_near(node, lattice_);
  const auto close = [&](const Triangle& t) {
    const Point &a = surface_.positions[t[0]], &b = surface_.positions[t[1]],
                &c = surface_.positions[t[2]];
    const Point low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const Point largest = near.cwiseMax(low.cwiseAbs()).cwiseMax(high.cwiseAbs());
    const double reach = reach_of(largest);
    if (((low - at).array() > reach).any() || ((at - high).array() > reach).any()) return false;
    // Seen from the node, at a scale at which squares stay in range, little is rounded away.
    const double scale = std::exp2(-std::ilogb((high - low).maxCoeff() + reach));
    const Point p = scale * (a - at), q = scale * (b - at), r = scale * (c - at);
    return distance_to_triangle(Point::Zero(), p, q, r) <= scale * reach;
  };
  return close(surface_.triangles[nearest_.triangle(at)]) ||
         std::any_of(surface_.triangles.begin(), surface_.triangles.end(), close);
}

}  // namespace suture::surgery
