// The one lattice that a tracker's detection, operation, improvement and distances share [§5].
#pragma once

#include "kernel/lattice.h"
#include "predicates/oracle.h"
#include "surgery/model/options.h"

namespace suture::surgery {

/// A lattice with the oracle that decides on which side of its shifted planes, lines and nodes the
/// mesh lies. Both must outlive it.
struct ShiftedLattice {
  const Lattice& lattice;
  const Oracle& oracle;
};

/// The lattice whose planes pass through options.origin, options.cell_size apart, round all
/// positions, with room for the deep-cell test. \pre a position \throw InvalidInput as
/// lattice_around
Lattice tracker_lattice(const std::vector<Point>& positions, const TrackerOptions& options);

}  // namespace suture::surgery
