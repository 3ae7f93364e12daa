// The rules of local operations: topology, orientation, lattice nodes, volume, features [§6.2].
#pragma once

#include "surgery/model/report.h"
#include "surgery/model/tracker_lattice.h"

namespace suture::surgery {

/// The rule that refused an operation, or `none`. `premature`: it would join two type 1 vertices
/// before the arc between them is due [§6.2].
enum class Refusal { none, link, normal, node, volume, feature, premature };

/// The limits of one operation; lengths and volumes in the scene's unit.
struct CollapseRules {
  const ShiftedLattice* nodes = nullptr;  ///< none of its nodes may be swept; null: any may
  double cos_turn = 0.5;                  ///< cosine of the most a normal may turn
  double volume_bound = 1e300;            ///< most volume that may be moved
  double cos_feature = -2;   ///< edges whose normals' cosine is below it are features; -2: none are
  double sliver_height = 0;  ///< a triangle no higher than this has no normal worth keeping
};

/// Counts one more that was refused for that reason; nothing for `none`.
void count_refusal(CollapseCounts& counts, Refusal refusal);

void add_to(CollapseCounts& sum, const CollapseCounts& counts);

}  // namespace suture::surgery
