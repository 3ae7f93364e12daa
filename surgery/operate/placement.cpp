// Incidence is decided before any of these numbers exists, so they can only affect shape.
#include "surgery/operate/placement.h"

#include <algorithm>

#include "predicates/construct.h"

namespace suture::surgery {

namespace {

double zero_of_distance(const Site& site, const Lattice& lattice, const DistanceField& distance) {
  const Index3 low = unpack(site.at), high = unpack(step(site.at, site.axis, 1));
  const double a = distance.at(low), b = distance.at(high);
  const double x = lattice.plane(site.axis, low[site.axis]);
  const double y = lattice.plane(site.axis, high[site.axis]);
  const double t = a == b ? 0.5 : a / (a - b);  // both are 0 where both nodes are on the surface
  return x + t * (y - x);
}

double inside_crossing(const Site& site, const Sites& sites) {
  const Crossings& crossings = sites.detected().crossings;
  const Winding& winding = sites.detected().winding;
  const CrossedEdge& edge = *winding.edge(site.axis, unpack(site.at));
  std::vector<std::pair<double, int>> along;  // position, change of winding
  for (std::uint32_t i = edge.first; i < edge.first + edge.count; ++i) {
    const LineCrossing& x = crossings.line_crossings[winding.order(site.axis)[i]];
    along.emplace_back(sites.crossing_position(site.axis, site.at, x.triangle)[site.axis], x.delta);
  }
  std::sort(along.begin(), along.end());
  std::vector<double> changes;
  int w = edge.before;
  for (const auto& [position, delta] : along) {
    if ((w >= 1) != (w + delta >= 1)) changes.push_back(position);
    w += delta;
  }
  return changes[changes.size() / 2];  // an odd number of them: the ends differ
}

}  // namespace

void place_isosurface(Placement placement, const DistanceField& distance, Sites& sites) {
  const Lattice& lattice = sites.detected().on.lattice;
  for (std::uint32_t s = 0; s < sites.all().size(); ++s) {
    Site& site = sites[s];
    if (site.kind != SiteKind::isosurface) continue;
    const double x = placement == Placement::distance_field
                         ? zero_of_distance(site, lattice, distance)
                         : inside_crossing(site, sites);
    const int k = unpack(site.at)[site.axis];
    site.position[site.axis] =
        clamp_to_cell(x, lattice.plane(site.axis, k), lattice.plane(site.axis, k + 1));
  }
}

}  // namespace suture::surgery
