// Surgery without a net: cut, fill and sew by site number alone; no audit, no second cut, no CGAL.
#pragma once

#include <algorithm>
#include <iterator>

#include "surgery/detect/complex_cells.h"
#include "surgery/detect/deep_cells.h"
#include "surgery/detect/region.h"
#include "surgery/model/tracker_lattice.h"
#include "surgery/operate/cut.h"
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

  Detected seen() const { return {scan.mesh, scan.on(), scan.crossings, scan.winding, region}; }
};

inline Detection detect(const Triangles& surface, const TrackerOptions& options) {
  Incidence mesh = incidence(surface);
  Lattice lattice = tracker_lattice(surface.positions, options);
  auto oracle = make_oracle(options.arithmetic);
  Crossings crossings = find_crossings(mesh, {lattice, *oracle});
  Winding winding(crossings);
  CellSet cells = find_complex_cells(crossings, winding);
  const EventCells seeds =
      find_events(cells, winding, {options.events, options.cell_test, options.depth});
  Region region = grow_region(seeds.cells, cells);
  return {{std::move(mesh), std::move(lattice), std::move(oracle), std::move(crossings),
           std::move(winding)},
          std::move(cells),
          std::move(region)};
}

inline constexpr Events kEvents[] = {Events::both, Events::merge, Events::split};

/// A case whose events are those of `seed`, so that zones of winding 2 and −1 stay in two of three.
inline HostileCase with_events(std::uint64_t seed) {
  HostileCase c = HostileCases(seed).make();
  c.options.events = kEvents[seed % 3];
  return c;
}

inline bool on_boundary(const Region& region, int axis, LatticeId edge) {
  const int cells = region.cells_round_edge(edge, axis);
  return cells > 0 && cells < 4;
}

/// Lattice edges that the region's boundary must not have: crossed twice, or without a change of
/// side; and faces of the boundary that hold a loop.
inline std::size_t faults(const Detection& d) {
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const CrossedEdge& e : d.scan.winding.edges(axis))
      if (on_boundary(d.region, axis, e.edge)) count += e.count != 1 || !e.changes_side();
    for (const LatticeId face : d.scan.crossings.loop_faces[axis])
      count += d.region.holds(face) != d.region.holds(step(face, axis, -1));
  }
  return count;
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
  Sites sites(d.seen());
  const CutMesh cut_mesh = cut({pieces}, sites);
  const std::vector<Arc> arcs = gather_arcs(cut_mesh.boundary, sites);
  const DistanceField distance(surface, d.scan.lattice, d.scan.winding);
  place_isosurface(placement, distance, sites);
  const Patch patch = fill(arcs, sites);
  return {without_touched(surface, cut_mesh.touched, {&cut_mesh.kept, &patch.triangles}, sites),
          cut_mesh.split_triangles, patch.centroids};
}

/// The surface cut along the region's boundary on both sides, nothing dropped yet.
inline Triangles cut_on_both_sides(const Triangles& surface, const Detection& d, Pieces pieces) {
  Sites sites(d.seen());
  CutMesh cut_mesh = cut({pieces, Inside::made}, sites);
  std::vector<std::uint32_t> replaced;
  std::set_difference(cut_mesh.touched.begin(), cut_mesh.touched.end(), cut_mesh.whole.begin(),
                      cut_mesh.whole.end(), std::back_inserter(replaced));
  return without_touched(surface, replaced, {&cut_mesh.kept, &cut_mesh.dropped}, sites);
}

}  // namespace suture
