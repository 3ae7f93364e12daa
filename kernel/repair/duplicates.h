// Triangles that are given more than once, and which of them stay.
#pragma once

#include <cstddef>

#include "kernel/triangles.h"

namespace suture {

struct DroppedCopies {
  std::size_t repeated = 0;   ///< were dropped, and another on the same vertices stayed
  std::size_t cancelled = 0;  ///< were dropped with all others on the same vertices
};

/// Leaves at most one triangle on any three vertices. Repeated triangles are judged in patches that
/// hang together at edges where just two vertex triples meet, both repeated. If other triangles end
/// at a patch, most of its edges to them decide: one of each stays where an odd number ends (a part
/// of a body), none where an even number does (a wall inside a body). Else the patch is a surface
/// by itself: none of it stays if most of its triangles cancel out, given as often one way as the
/// other, as it then encloses no volume. Of copies that stay, the first that faces as most do is
/// kept. Unusable triangles are passed over.
DroppedCopies drop_duplicates(Triangles& surface);

}  // namespace suture
