// Type 2 vertices are collapsed after the surface is closed, so nothing can gridlock [§6.1 step 3].
#pragma once

#include <vector>

#include "surgery/collapse/rules.h"
#include "surgery/model/report.h"

namespace suture::surgery {

/// Collapses each of `type2` onto a neighbour that is type 1 or, failing that, another type 2
/// vertex, so that the region's boundary runs straight between type 1 vertices; shortest edge
/// first, and tried again whenever a collapse nearby has changed its star. What no rule allows
/// stays and is counted once, under the rule that refused it last; as `delayed` where it has no
/// neighbour of either type. Deterministic; garbage is left in place.
CollapseCounts straighten(Mesh& mesh, const std::vector<Mesh::Vertex_index>& type2,
                          const std::vector<Mesh::Vertex_index>& type1, const CollapseRules& rules);

}  // namespace suture::surgery
