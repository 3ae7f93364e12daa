// Type 2 vertices are collapsed after the surface is closed, so nothing can gridlock [§6.1 step 3].
#pragma once

#include "surgery/collapse/rules.h"
#include "surgery/operate/stitch.h"

namespace suture::surgery {

/// Collapses type 2 vertices as collapse_type2 does, wherever the rules allow it, so that the
/// region's boundary runs straight between type 1 vertices. \pre the mesh is closed
CollapseCounts straighten(Mesh& mesh, const StitchedVertices& vertices, const CollapseRules& rules);

}  // namespace suture::surgery
