// Every measure of a surface against the exact one.
#include "sims/study/compare.h"

#include <algorithm>

#include "kernel/measure/distance.h"
#include "kernel/measure/measures.h"
#include "kernel/measure/nearest_triangle.h"
#include "kernel/measure/symmetric_difference.h"

namespace suture::sims {
namespace {

struct Distances {
  double mean = kUnknown, max = kUnknown;
};

/// Distances along the creases: the mean by length, from the middles of the pieces, and the largest
/// of middles and ends.
Distances crease_distances(const ExactSurface& exact, const NearestTriangle& nearest) {
  double sum = 0, whole = 0, most = 0;
  for (const auto& [a, b] : exact.creases) {
    const Point &p = exact.surface.positions[a], &q = exact.surface.positions[b];
    const double length = (q - p).norm(), d = nearest.distance((p + q) / 2);
    sum += length * d;
    whole += length;
    most = std::max({most, d, nearest.distance(p), nearest.distance(q)});
  }
  return whole > 0 ? Distances{sum / whole, most} : Distances{};
}

Distances corner_distances(const ExactSurface& exact, const NearestTriangle& nearest) {
  if (exact.corners.empty()) return {};
  double sum = 0, most = 0;
  for (const std::uint32_t v : exact.corners) {
    const double d = nearest.distance(exact.surface.positions[v]);
    sum += d;
    most = std::max(most, d);
  }
  return {sum / static_cast<double>(exact.corners.size()), most};
}

}  // namespace

Row compare(const Triangles& surface, const Truth& truth, const CompareOptions& options) {
  const ExactSurface& exact = truth.exact;
  TwoWayDistance d;
  d.forth = d.back = {kUnknown, kUnknown, kUnknown};
  Distances creases, corners;
  SymmetricDifference difference{.volume = truth.volume};
  const double v = surface.triangles.empty() ? 0 : volume(surface);
  if (!surface.triangles.empty()) {
    d = surface_distance(surface, exact.surface, {.samples = options.samples});
    const NearestTriangle nearest(surface);
    creases = crease_distances(exact, nearest);
    corners = corner_distances(exact, nearest);
    difference = symmetric_difference(surface, exact.surface, {.lines = options.lines});
  }
  return {{"volume_error", v / truth.volume - 1},
          {"symmetric_difference", difference.volume / truth.volume},
          {"symmetric_difference_error", difference.error / truth.volume},
          {"line_spacing", difference.spacing},
          {"mean_distance", d.mean()},
          {"max_distance", d.hausdorff()},
          {"mean_distance_forth", d.forth.mean},
          {"mean_distance_back", d.back.mean},
          {"max_distance_forth", d.forth.max},
          {"max_distance_back", d.back.max},
          {"sample_spacing", d.back.spacing},
          {"crease_mean", creases.mean},
          {"crease_max", creases.max},
          {"corner_mean", corners.mean},
          {"corner_max", corners.max},
          {"reference_tolerance", exact.tolerance},
          {"reference_mean_error", exact.mean_error},
          {"reference_max_error", exact.max_error}};
}

Row compare_markers(const Triangles& surface, const Triangles& start, const Carry& carry) {
  double sum = kUnknown, most = kUnknown;
  if (surface.triangles == start.triangles) {
    sum = most = 0;
    for (std::size_t i = 0; i < start.positions.size(); ++i) {
      const double d = (carry(start.positions[i]) - surface.positions[i]).norm();
      sum += d / static_cast<double>(start.positions.size());
      most = std::max(most, d);
    }
  }
  return {{"marker_mean", sum}, {"marker_max", most}};
}

}  // namespace suture::sims
