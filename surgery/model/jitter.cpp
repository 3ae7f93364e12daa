// Random displacements from a hash of each vertex, so that no state is kept between remodels
// [§5.3].
#include "surgery/model/jitter.h"

#include <bit>

#include "kernel/random.h"

namespace suture::surgery {

bool jitters(const TrackerOptions& options) {
  return options.arithmetic == Arithmetic::rounded && options.jitter > 0;
}

Surface jittered(Surface surface, const TrackerOptions& options) {
  const double reach = options.jitter * options.cell_size;
  for (std::uint32_t v = 0; v < surface.triangles.positions.size(); ++v) {
    Point& p = surface.triangles.positions[v];
    std::uint64_t seed = v;
    for (const double x : p) seed = Random(seed ^ std::bit_cast<std::uint64_t>(x)).next();
    Random random(seed);
    for (double& x : p) x += random.uniform(-reach, reach);
    surface.mesh.point(Mesh::Vertex_index(v)) = to_cgal(p);
  }
  return surface;
}

}  // namespace suture::surgery
