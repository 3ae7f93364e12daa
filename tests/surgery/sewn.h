// Surgery without a net: cut, fill and sew by site number alone; no audit, no second cut, no CGAL.
#pragma once

#include <algorithm>
#include <iterator>

#include "surgery/detect/complex_cells.h"
#include "surgery/detect/deep_cells.h"
#include "surgery/detect/region.h"
#include "surgery/model/tracker_lattice.h"
#include "surgery/operate/fill.h"
#include "surgery/operate/placement.h"
#include "tests/surgery/hostile.h"
#include "tests/surgery/support.h"

namespace suture {

using namespace suture::surgery;

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

/// The surface without what the cut touched, and with triangles of sites in its place.
inline Triangles without_touched(const Triangles& surface,
                                 const std::vector<std::uint32_t>& touched,
                                 const std::vector<const std::vector<Triangle>*>& groups,
                                 const Sites& sites) {
  Triangles result{surface.positions, {}};
  std::vector<char> gone(surface.triangles.size(), 0);
  for (const std::uint32_t t : touched) gone[t] = 1;
  for (std::uint32_t t = 0; t < gone.size(); ++t)
    if (gone[t] == 0) result.triangles.push_back(surface.triangles[t]);
  std::vector<std::uint32_t> vertex(sites.all().size(), kNone);
  auto number = [&](std::uint32_t site) {
    const Site& s = sites[site];
    if (s.kind == SiteKind::corner) return s.source;
    if (vertex[site] == kNone) {
      vertex[site] = static_cast<std::uint32_t>(result.positions.size());
      result.positions.push_back(s.position);
    }
    return vertex[site];
  };
  for (const auto* triangles : groups)
    for (const Triangle& t : *triangles)
      result.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
  return result;
}

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
  return {without_touched(surface, cut_mesh.touched, {&cut_mesh.kept, &patch.triangles}, sites),
          cut_mesh.split_triangles, patch.centroids};
}

/// The surface cut along the region's boundary on both sides, nothing dropped yet.
inline Triangles cut_on_both_sides(const Triangles& surface, const Detection& d, Pieces pieces) {
  Sites sites(d.scan.mesh, d.scan.lattice, d.scan.crossings, d.scan.winding, d.region);
  CutMesh cut_mesh = cut({d.scan.mesh, d.scan.lattice, *d.scan.oracle, d.scan.crossings, d.region},
                         {pieces, Inside::made}, sites);
  std::vector<std::uint32_t> replaced;
  std::set_difference(cut_mesh.touched.begin(), cut_mesh.touched.end(), cut_mesh.whole.begin(),
                      cut_mesh.whole.end(), std::back_inserter(replaced));
  return without_touched(surface, replaced, {&cut_mesh.kept, &cut_mesh.dropped}, sites);
}

}  // namespace suture
