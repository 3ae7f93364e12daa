// How far two surfaces are apart, by sampling both.
#pragma once

#include "kernel/triangles.h"

namespace suture {

struct SamplingOptions {
  std::size_t samples = 100000;  ///< on each surface, spread evenly over its area
};

/// From the samples of one surface to the other, in the scene's unit.
struct OneWayDistance {
  double mean = 0;     ///< over the area of the sampled surface
  double max = 0;      ///< over samples and vertices: never above the true one-sided Hausdorff
                       ///< distance, and below it by at most about `spacing`
  double spacing = 0;  ///< √(area / samples): the mean distance between samples
};

struct TwoWayDistance {
  OneWayDistance forth, back;  ///< from the first surface to the second, and back
  double mean() const { return (forth.mean + back.mean) / 2; }
  double hausdorff() const { return forth.max > back.max ? forth.max : back.max; }
};

/// Mean and largest distance between two surfaces, both ways. Samples are a fixed low-discrepancy
/// pattern, so the result is the same every time. O((n + samples) log n).
/// \throw InvalidInput if either surface has no triangle, no finite area, or a broken index
TwoWayDistance surface_distance(const Triangles& a, const Triangles& b,
                                const SamplingOptions& options = {});

/// From `samples` to the nearest points of `to` only.
OneWayDistance one_way_distance(const Triangles& from, const Triangles& to,
                                const SamplingOptions& options = {});

}  // namespace suture
