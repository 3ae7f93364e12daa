// Surgery without a net: cut, fill and sew by site number alone; no audit, no second cut, no CGAL.
#pragma once

#include <optional>

#include "surgery/complex_cells.h"
#include "surgery/deep_cells.h"
#include "surgery/fill.h"
#include "surgery/placement.h"
#include "surgery/region.h"
#include "surgery/tracker_lattice.h"
#include "tests/surgery/hostile.h"
#include "tests/surgery/support.h"

namespace suture {

/// Detection on the tracker's lattice, up to the region.
struct Detection {
  Scan scan;
  CellSet cells;
  Region region;
};

inline Detection detect(const Triangles& surface, const TrackerOptions& options) {
  Incidence mesh = incidence(surface);
  Lattice lattice = tracker_lattice(surface.positions, options);
  auto oracle = make_oracle(options.arithmetic);
  Crossings crossings = find_crossings(mesh, lattice, *oracle);
  Winding winding(crossings);
  CellSet cells = find_complex_cells(crossings, winding);
  MarkedCells marked;
  const auto seeds =
      find_events(cells, winding, {options.events, options.cell_test, options.depth}, marked);
  Region region = grow_region(seeds, cells);
  return {{std::move(mesh), std::move(lattice), std::move(oracle), std::move(crossings),
           std::move(winding)},
          std::move(cells),
          std::move(region)};
}

struct Sewn {
  Triangles surface;
  std::size_t split_triangles = 0, centroids = 0;
};

/// The surface after surgery in the region, as the cut and the fill give it.
inline Sewn sew(const Triangles& surface, const Detection& d, Pieces pieces,
                Placement placement = Placement::crossing) {
  Sites sites(d.scan.mesh, d.scan.lattice, d.scan.crossings, d.scan.winding, d.region);
  const CutMesh cut_mesh = cut(
      {d.scan.mesh, d.scan.lattice, *d.scan.oracle, d.scan.crossings, d.region}, {pieces}, sites);
  const std::vector<Arc> arcs = gather_arcs(cut_mesh.boundary, d.region, d.scan.winding, sites);
  const DistanceField distance(surface, d.scan.lattice, d.scan.winding);
  place_isosurface(placement, d.scan.crossings, d.scan.winding, d.scan.lattice, distance, sites);
  const Patch patch = fill(arcs, sites);

  Sewn result{{surface.positions, {}}, cut_mesh.split_triangles, patch.centroids};
  std::vector<char> gone(surface.triangles.size(), 0);
  for (const std::uint32_t t : cut_mesh.touched) gone[t] = 1;
  for (std::uint32_t t = 0; t < gone.size(); ++t)
    if (gone[t] == 0) result.surface.triangles.push_back(surface.triangles[t]);
  std::vector<std::uint32_t> vertex(sites.all().size(), kNone);
  auto number = [&](std::uint32_t site) {
    const Site& s = sites[site];
    if (s.kind == SiteKind::corner) return s.source;
    if (vertex[site] == kNone) {
      vertex[site] = static_cast<std::uint32_t>(result.surface.positions.size());
      result.surface.positions.push_back(s.position);
    }
    return vertex[site];
  };
  for (const auto* triangles : {&cut_mesh.kept, &patch.triangles})
    for (const Triangle& t : *triangles)
      result.surface.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
  return result;
}

}  // namespace suture
