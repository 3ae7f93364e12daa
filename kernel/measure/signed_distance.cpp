// Windings are counted along the ray from p in the direction of the first axis, with p shifted by
// (0, ε₁, ε₂), ε₁ ≫ ε₂ > 0: no ray meets an edge or a vertex, and no case is special.
#include "kernel/measure/signed_distance.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>

namespace suture {

namespace {

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

// On which side of the edge from u to v the shifted p is, seen against the ray: 1 on its left, else
// −1.
int side_of_edge(const Point& p, const Point& u, const Point& v) {
  const auto sign = CGAL::orientation(Exact::Point_2(u[1], u[2]), Exact::Point_2(v[1], v[2]),
                                      Exact::Point_2(p[1], p[2]));
  if (sign != CGAL::ZERO) return sign;
  return v[2] > u[2] ? -1 : 1;  // ε₁ leads to the right of an edge that goes up
}

// How often the triangle's outline goes round the shifted p, seen against the ray: −1, 0 or 1.
int turns(const Point& p, const std::array<const Point*, 3>& corners) {
  int total = 0;
  for (int k = 0; k < 3; ++k) {
    const Point &u = *corners[k], &v = *corners[(k + 1) % 3];
    const bool from_below = u[2] <= p[2], to_below = v[2] <= p[2];
    if (from_below == to_below) continue;
    const int side = side_of_edge(p, u, v);
    if (from_below && side > 0) ++total;
    if (to_below && side < 0) --total;
  }
  return total;
}

Exact::Point_3 exact(const Point& p) { return {p[0], p[1], p[2]}; }

}  // namespace

int SignedDistance::winding(const Point& p) const {
  std::vector<std::uint32_t> candidates;
  nearest_.along_first_axis(p, candidates);
  int total = 0;
  for (const std::uint32_t i : candidates) {
    const Triangle& t = surface_.triangles[i];
    const std::array<const Point*, 3> corners = {
        &surface_.positions[t[0]], &surface_.positions[t[1]], &surface_.positions[t[2]]};
    const int turned = turns(p, corners);
    if (turned == 0) continue;
    const int above =
        CGAL::orientation(exact(*corners[0]), exact(*corners[1]), exact(*corners[2]), exact(p));
    if (above * turned < 0) total += turned;
  }
  return total;
}

double SignedDistance::at(const Point& p) const {
  const double distance = nearest_.distance(p);
  return winding(p) > 0 ? -distance : distance;
}

}  // namespace suture
