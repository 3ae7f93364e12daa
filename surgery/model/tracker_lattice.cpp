// The margin beyond the depth keeps every cell beside a surface cell inside the lattice.
#include "surgery/model/tracker_lattice.h"

namespace suture::surgery {

Lattice tracker_lattice(const std::vector<Point>& positions, const TrackerOptions& options) {
  constexpr int kMargin = 3;  // whole cells
  return lattice_around(bounding_box(positions), options.cell_size, options.origin,
                        options.depth + kMargin);
}

}  // namespace suture::surgery
