// The isosurface that replaces the region's mesh, cell by cell [§6.1 step 5].
#pragma once

#include <vector>

#include "surgery/operate/sites.h"

namespace suture::surgery {

/// Triangles in the region's cells, by site, whose boundary is that of the cut mesh reversed.
struct Patch {
  std::vector<Triangle> triangles;
  std::size_t loops = 0, centroids = 0;
};

/// All arcs round the faces of the region's cells: `boundary` on boundary faces, marching
/// squares on interior ones, where inside corners of an ambiguous face are kept apart in both
/// cells. Adds the sites of isosurface vertices, unplaced. \throw InternalFailure if the windings
/// contradict the crossings
std::vector<Arc> gather_arcs(std::vector<Arc> boundary, Sites& sites);

/// Links the arcs of each cell to loops and triangulates them; no diagonal joins two vertices of
/// one lattice face. \pre every site has its position \throw InternalFailure if arcs do not close
Patch fill(const std::vector<Arc>& arcs, Sites& sites);

}  // namespace suture::surgery
