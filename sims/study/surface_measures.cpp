// The measures of a surface by itself: its topology and its worst places.
#include "sims/study/surface_measures.h"

#include "kernel/measure/measures.h"
#include "kernel/measure/self_intersections.h"

namespace suture::sims {

SurfaceMeasures measure_surface(const Triangles& surface) {
  constexpr std::size_t most_pairs = 1000000;
  const SelfIntersections pairs = self_intersections(surface, {.most = most_pairs});
  return {.components = static_cast<double>(components(surface).count),
          .euler = static_cast<double>(euler_characteristic(surface)),
          .intersecting_pairs = static_cast<double>(pairs.pairs.size()),
          .without_area = static_cast<double>(pairs.without_area),
          .least_angle = angles(surface).smallest};
}

}  // namespace suture::sims
