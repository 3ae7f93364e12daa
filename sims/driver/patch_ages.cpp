// The age of a surface's parts: how long ago surgery made each vertex, and whether it did at all.
#include "sims/driver/patch_ages.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "sims/tracking/vertex_values.h"

namespace suture::sims {

PatchAges::PatchAges(std::size_t vertices, double fading)
    : fading_(fading), freshness_(vertices, 0.0), resampled_(vertices, 0.0) {}

void PatchAges::moved(double dt) {
  for (double& f : freshness_) f = fading_ > 0 ? std::max(0.0, f - dt / fading_) : 0.0;
}

void PatchAges::remodelled(const SurgeryReport& report, const Triangles& surface) {
  carry(surface, report.vertex_map);
  std::vector<char> old(freshness_.size(), 0);
  for (const std::uint32_t v : report.vertex_map)
    if (v != kNone) old[v] = 1;
  for (std::size_t v = 0; v < old.size(); ++v)
    if (old[v] == 0) freshness_[v] = resampled_[v] = 1;
}

void PatchAges::improved(const QualityReport& report, const Triangles& surface) {
  carry(surface, report.vertex_map);
}

void PatchAges::carry(const Triangles& surface, const std::vector<std::uint32_t>& vertex_map) {
  freshness_ = carried(freshness_, 0.0, surface, vertex_map);
  resampled_ = carried(resampled_, 0.0, surface, vertex_map);
}

double PatchAges::untouched_area(const Triangles& surface) const {
  double untouched = 0, all = 0;
  for (const auto& t : surface.triangles) {
    const Point& a = surface.positions[t[0]];
    const double area = (surface.positions[t[1]] - a).cross(surface.positions[t[2]] - a).norm();
    all += area;
    if (std::max({resampled_[t[0]], resampled_[t[1]], resampled_[t[2]]}) < 0.5) untouched += area;
  }
  return all > 0 ? untouched / all : 1;
}

}  // namespace suture::sims
