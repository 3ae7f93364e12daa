// The fill's own vertices are placed along their lattice edges [§6.1 step 5].
#pragma once

#include "surgery/detect/distance_field.h"
#include "surgery/model/options.h"
#include "surgery/operate/sites.h"

namespace suture::surgery {

/// Gives every isosurface vertex its position: the zero of D, linear between the edge's two nodes;
/// or the mesh's own crossing from outside to inside (the middle one where there are several).
/// Positions are clamped to the doubles of their lattice edge. `distance` is read for the former
/// only.
void place_isosurface(Placement placement, const DistanceField& distance, Sites& sites);

}  // namespace suture::surgery
