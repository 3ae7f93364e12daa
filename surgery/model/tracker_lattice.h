// The one lattice that detection, improvement and distances of a tracker share [§5].
#pragma once

#include "kernel/lattice.h"
#include "surgery/model/options.h"

namespace suture::surgery {

/// Planes through options.origin, options.cell_size apart, round all positions, with room for the
/// deep-cell test. \pre a position \throw InvalidInput as lattice_around
Lattice tracker_lattice(const std::vector<Point>& positions, const TrackerOptions& options);

}  // namespace suture::surgery
