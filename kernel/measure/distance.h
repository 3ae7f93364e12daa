// How far two surfaces are apart, by sampling both.
#pragma once

#include "kernel/triangles.h"

namespace suture {

struct SamplingOptions {
  std::size_t samples = 100000;  ///< their number on each surface, spread evenly over its area
};

/// Distances from the samples of one surface to the other, in the scene's unit of length.
struct OneWayDistance {
  double mean = 0;     ///< the mean over the area of the sampled surface
  double max = 0;      ///< the largest over samples and vertices: never above the true one-sided
                       ///< Hausdorff distance, and below it by at most about `spacing`
  double spacing = 0;  ///< √(area / samples): the mean distance between samples
};

struct TwoWayDistance {
  OneWayDistance forth, back;  ///< forth is from the first surface to the second
  double mean() const { return (forth.mean + back.mean) / 2; }
  double hausdorff() const { return forth.max > back.max ? forth.max : back.max; }
};

/// Measures the mean and largest distance between two surfaces, both ways. The samples are a fixed
/// low-discrepancy pattern, so the result is the same every time. It takes O((n + samples) log n).
/// \throw InvalidInput if either surface has no triangle, no finite area, or an index out of range,
/// or if no sample is asked for
TwoWayDistance surface_distance(const Triangles& a, const Triangles& b,
                                const SamplingOptions& options = {});

/// Measures one way only: from the samples of `from` to the nearest points of `to`.
/// \throw InvalidInput as surface_distance does
OneWayDistance one_way_distance(const Triangles& from, const Triangles& to,
                                const SamplingOptions& options = {});

}  // namespace suture
