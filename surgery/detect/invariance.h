// The last part of the audit: surgery must not change windings outside its region [§5.3].
#pragma once

#include "surgery/detect/region.h"
#include "surgery/detect/winding.h"

namespace suture::surgery {

/// What surgery took out of the surface (reversed) and put in: a closed chain of triangles.
/// \param kept for each triangle of `after`, the triangle of `before` that it is, or kNone
/// \param vertex_map vertices of `before` to those of `after`, or kNone
Triangles difference(const Triangles& before, const Triangles& after,
                     const std::vector<std::uint32_t>& kept,
                     const std::vector<std::uint32_t>& vertex_map);

/// Nodes with a cell outside the region whose winding the surgery changed although it was 0 or 1,
/// or whose side it changed, in a defined order. (Where bodies overlap or are inverted, nodes in
/// cells without mesh may go from 2 to 1 or from −1 to 0 as the sheets round them are replaced:
/// their side stays.) With both events there are none but for nodes within rounding of the surface,
/// since inserted vertices are rounded; with one event there may be others [papers/proof.md, 9.3].
/// Nodes with all their cells in the region are not looked at, though with one event these too may
/// change side: a known fault. \throw InternalFailure if the oracle contradicts itself
std::vector<Index3> changed_outside(const Triangles& difference, const Lattice& lattice,
                                    const Oracle& oracle, const Region& region,
                                    const Winding& before);

}  // namespace suture::surgery
