// An edge collapses where all rules allow it [§6.1 step 3, §6.2].
#pragma once

#include "surgery/collapse/local_change.h"

namespace suture::surgery {

/// Whether the source of `h` may be collapsed onto its target, which stays where it is.
/// Rules in order: link condition (and no component may vanish); no triangle turned over, or turned
/// by more than the bound; no node of the shifted lattice swept; volume (the sum of the absolute
/// volumes of the swept tetrahedra); features. A sliver's own normal says nothing: it may turn as
/// it likes while it stays a sliver, and if it grows it must face the way its star does.
Refusal may_collapse(const Mesh& mesh, Mesh::Halfedge_index h, const CollapseRules& rules);

/// The same for a collapse after which the target stands elsewhere. A vertex on a feature may not
/// move, so `collapse.to` must then be where the target is.
Refusal may_collapse_to(const Mesh& mesh, const EdgeCollapse& collapse, const CollapseRules& rules);

/// Collapses the source of `h` onto its target. \pre may_collapse gave Refusal::none
/// \return the vertex that stays: always the target of `h`, with its index and position
Mesh::Vertex_index collapse(Mesh& mesh, Mesh::Halfedge_index h);

}  // namespace suture::surgery
