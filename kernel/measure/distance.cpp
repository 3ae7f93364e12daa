// Samples are systematic: every equal part of the area has one, placed in its triangle by the
// additive sequence of the plastic number, which fills a square evenly.
#include "kernel/measure/distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/errors.h"
#include "kernel/measure/nearest_triangle.h"

namespace suture {

namespace {

constexpr double kStep1 = 0.75487766624669276;  // 1/ρ and 1/ρ² for the plastic number ρ: ρ³ = ρ + 1
constexpr double kStep2 = 0.56984029099805327;

std::vector<double> areas(const Triangles& surface) {
  std::vector<double> result;
  result.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    for (const std::uint32_t v : t)
      if (v >= surface.positions.size())
        throw InvalidInput("triangle " + std::to_string(result.size()) + " has the vertex " +
                           std::to_string(v) + ", which does not exist; audit the surface first");
    const Point& a = surface.positions[t[0]];
    result.push_back((surface.positions[t[1]] - a).cross(surface.positions[t[2]] - a).stableNorm() /
                     2);
  }
  return result;
}

// The i-th point of the sequence, folded from the square into the triangle.
Point place(const Triangles& surface, const Triangle& t, std::size_t i) {
  double u = std::fmod(0.5 + static_cast<double>(i) * kStep1, 1);
  double v = std::fmod(0.5 + static_cast<double>(i) * kStep2, 1);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Point& a = surface.positions[t[0]];
  return a + u * (surface.positions[t[1]] - a) + v * (surface.positions[t[2]] - a);
}

OneWayDistance sampled(const Triangles& from, const NearestTriangle& to, std::size_t samples) {
  const std::vector<double> area = areas(from);
  double whole = 0;
  for (const double x : area) whole += x;
  if (!(whole > 0) || !std::isfinite(whole) || samples == 0)
    throw InvalidInput(
        "distances are sampled by area: the surface needs one that is finite and not zero, and "
        "at least one sample; check its triangles and its scale");
  const double share = whole / static_cast<double>(samples);
  OneWayDistance result;
  result.spacing = std::sqrt(share);
  double sum = 0, reached = 0;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < area.size(); ++i) {
    reached += area[i];
    for (; taken < samples && (static_cast<double>(taken) + 0.5) * share <= reached; ++taken) {
      const double d = to.distance(place(from, from.triangles[i], taken));
      sum += d;
      result.max = std::max(result.max, d);
    }
  }
  result.mean = taken > 0 ? sum / static_cast<double>(taken) : 0;
  std::vector<std::uint8_t> used(from.positions.size(), 0);
  for (const Triangle& t : from.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] != 0) result.max = std::max(result.max, to.distance(from.positions[v]));
  return result;
}

}  // namespace

OneWayDistance one_way_distance(const Triangles& from, const Triangles& to,
                                const SamplingOptions& options) {
  return sampled(from, NearestTriangle(to), options.samples);
}

TwoWayDistance surface_distance(const Triangles& a, const Triangles& b,
                                const SamplingOptions& options) {
  const NearestTriangle to_a(a), to_b(b);  // checks the indices of both
  return {sampled(a, to_b, options.samples), sampled(b, to_a, options.samples)};
}

}  // namespace suture
