// The colour of each triangle: what surgery made, or which component it belongs to.
#include "sims/output/colours.h"

#include <algorithm>
#include <array>

#include "kernel/measure/measures.h"

namespace suture::sims {
namespace {

const Eigen::Vector3f kClay(0.80f, 0.83f, 0.86f), kAccent(0.93f, 0.42f, 0.16f);

/// Okabe and Ito's palette, softened; told apart by the colour-blind as well.
constexpr std::array<std::array<float, 3>, 7> kPalette = {{{0.36f, 0.62f, 0.82f},
                                                           {0.93f, 0.65f, 0.26f},
                                                           {0.33f, 0.70f, 0.56f},
                                                           {0.84f, 0.48f, 0.36f},
                                                           {0.76f, 0.56f, 0.72f},
                                                           {0.91f, 0.85f, 0.45f},
                                                           {0.55f, 0.58f, 0.64f}}};

}  // namespace

TriangleColours patch_colours(const Triangles& surface, const std::vector<double>& freshness) {
  TriangleColours colours;
  colours.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const double x = freshness[a], y = freshness[b], z = freshness[c];
    const double median = std::max(std::min(x, y), std::min(std::max(x, y), z));
    const auto share = static_cast<float>(std::clamp(median, 0.0, 1.0));
    colours.push_back(kClay + share * (kAccent - kClay));
  }
  return colours;
}

TriangleColours component_colours(const Triangles& surface) {
  TriangleColours colours;
  colours.reserve(surface.triangles.size());
  for (const std::uint32_t part : components(surface).of_triangle) {
    const auto& c = kPalette[part % kPalette.size()];
    colours.emplace_back(c[0], c[1], c[2]);
  }
  return colours;
}

}  // namespace suture::sims
