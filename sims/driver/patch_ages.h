// The age of a surface's parts: how long ago surgery made each vertex, and whether it did at all.
#pragma once

#include <vector>

#include "kernel/triangles.h"
#include "surgery/model/report.h"

namespace suture::sims {

/// Follows the vertices of one mesh through moves, remodels and improvements.
class PatchAges {
 public:
  /// \param fading the time in which a vertex that surgery made stops being fresh; 0: at once
  PatchAges(std::size_t vertices, double fading);

  void moved(double dt);
  /// \param surface as the committed surgery, or the improvement, left it
  void remodelled(const SurgeryReport& report, const Triangles& surface);
  void improved(const QualityReport& report, const Triangles& surface);

  /// A number for each vertex: 1 as surgery made it, fading to 0.
  const std::vector<double>& freshness() const { return freshness_; }
  /// The part of the area whose triangles have no corner that surgery ever made.
  double untouched_area(const Triangles& surface) const;

 private:
  void carry(const Triangles& surface, const std::vector<std::uint32_t>& vertex_map);

  double fading_;
  std::vector<double> freshness_;
  std::vector<double> resampled_;  ///< of each vertex 1 as surgery made it, and it stays so
};

}  // namespace suture::sims
