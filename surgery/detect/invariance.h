// The last part of the audit: surgery must not change the side of a node [§5.3].
#pragma once

#include "surgery/detect/region.h"
#include "surgery/detect/winding.h"

namespace suture::surgery {

/// The origin of each part of a surface after surgery in the surface before; kNone: it has none.
struct Lineage {
  const std::vector<std::uint32_t>& triangle_origin;  ///< new triangle → the same one before
  const std::vector<std::uint32_t>& vertex_map;       ///< old vertex → new one
};

/// The triangles that surgery took out of the surface (reversed) and those that it put in: a closed
/// chain.
Triangles difference(const Triangles& before, const Triangles& after, const Lineage& lineage);

/// Nodes, wherever they are, whose side the surgery changed, or whose winding it changed although
/// that was 0 or 1, in a defined order. (Where bodies overlap or are inverted, nodes may go from 2
/// to 1 or from −1 to 0 as the sheets round them are replaced: their side stays.) There are none
/// but for nodes within rounding of the surface, since inserted vertices are rounded
/// [papers/proof.md, 9]. \throw InternalFailure if the oracle contradicts itself
std::vector<Index3> wrongly_changed(const Triangles& difference, const Detected& before);

}  // namespace suture::surgery
