// Whole surfaces are marched and measured again, whatever the tracker thinks of them.
#include "sims/fuzz/surface_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "kernel/audit.h"
#include "kernel/random.h"
#include "surgery/check/surgery_check.h"
#include "surgery/detect/rounding.h"
#include "surgery/tracker.h"

namespace suture::sims {

namespace {

/// With jitter each remodel moves the surface first: vertices, and nodes' sides, may change.
bool jitters(const Observation& o) {
  return o.options.arithmetic == Arithmetic::rounded && o.options.jitter > 0;
}

std::string name_of(const Index3& node) {
  return fmt::format("node {} {} {}", node[0], node[1], node[2]);
}

/// The nodes within `reach` cells of some cells, those of the cells included.
std::vector<Index3> corners_of(const std::vector<LatticeId>& cells, int reach) {
  std::set<Index3> nodes;
  for (const LatticeId cell : cells)
    for (int i = -reach; i <= reach + 1; ++i)
      for (int j = -reach; j <= reach + 1; ++j)
        for (int k = -reach; k <= reach + 1; ++k) {
          const Index3 at = unpack(cell);
          if (std::min({at[0] + i, at[1] + j, at[2] + k}) >= 0)
            nodes.insert({at[0] + i, at[1] + j, at[2] + k});
        }
  return {nodes.begin(), nodes.end()};
}

/// The options with an arithmetic that does not err, for judging whatever arithmetic was used.
TrackerOptions exactly(TrackerOptions options) {
  options.arithmetic = Arithmetic::filtered;
  return options;
}

/// Solid angle of the surface over 4π. Each vector is taken at its own scale, so nothing over- or
/// underflows.
double solid_angle(const Triangles& surface, const Point& at) {
  double sum = 0;
  for (const Triangle& t : surface.triangles) {
    Point v[3];
    for (int k = 0; k < 3; ++k) {
      v[k] = surface.positions[t[static_cast<std::size_t>(k)]] - at;
      v[k] /= v[k].cwiseAbs().maxCoeff();
      v[k] /= v[k].norm();
    }
    sum += 2 * std::atan2(v[0].dot(v[1].cross(v[2])),
                          1 + v[0].dot(v[1]) + v[1].dot(v[2]) + v[2].dot(v[0]));
  }
  return sum / (4 * std::numbers::pi);
}

}  // namespace

/// Surgery and improvement leave a closed, oriented, edge- and vertex-manifold, finite surface, or
/// nothing at all: Suture's claim.
Objection check_audit(const Observation& o) {
  if ((!committed(o) && o.quality == nullptr) || o.after.triangles.empty()) return {};
  const Audit result = audit(o.after);
  if (result.closed_manifold() && result.isolated_vertices == 0) return {};
  return result.first.empty() ? "isolated vertices" : result.first;
}

/// A remodel that changes nothing, or is refused, leaves every bit: it works on a copy.
Objection check_bits(const Observation& o) {
  if (o.surgery == nullptr || committed(o) || same_bits(o.before, o.after)) return {};
  return o.surgery->outcome == Outcome::refused ? "a refused remodel changed the surface"
                                                : "an unchanged surface has other bits";
}

/// An old vertex that survives is where it was, and only it is mapped there: surgery moves nothing.
Objection check_map(const Observation& o) {
  if (o.surgery == nullptr) return {};
  const auto& map = o.surgery->vertex_map;
  if (o.before.triangles.empty() || jitters(o)) return {};
  if (map.size() != o.before.positions.size()) return "the vertex map has not the old length";
  std::vector<char> used(o.after.positions.size(), 0);
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (map[v] == kNone) continue;
    if (map[v] >= used.size()) return fmt::format("vertex {} is mapped out of range", v);
    if (used[map[v]] != 0) return fmt::format("vertex {} shares its new vertex with another", v);
    used[map[v]] = 1;
    if (o.before.positions[v] != o.after.positions[map[v]])
      return fmt::format("surviving vertex {} has moved", v);
  }
  return {};
}

/// The marches along x, y and z count the same windings on any closed surface.
Objection check_marches(const Observation& o) {
  if (!committed(o) || o.after.triangles.empty()) return {};
  if (SurfaceCheck(o.after, lattice_of(o.after.positions, o.options)).marches_agree()) return {};
  return "the marches along the axes disagree on the surface after a remodel";
}

/// The side of every node is the same before and after a remodel, unless it is within rounding of
/// the surface. Here both whole surfaces are marched; the remodel's own audit marches what was
/// taken out and put in.
Objection check_invariance(const Observation& o) {
  if (!committed(o) || jitters(o)) return {};
  const Lattice lattice = lattice_of(o.before.positions, o.options);
  const SurfaceCheck before(o.before, lattice), after(o.after, lattice);
  const std::vector<Index3> changed = SurfaceCheck::sides_changed(before, after);
  if (changed.empty()) return {};
  const surgery::Rounding rounding(o.before, lattice);
  for (const Index3& node : changed)
    if (!rounding.reaches(node))
      return fmt::format("{} changed from winding {} to {}", name_of(node), before.winding(node),
                         after.winding(node));
  return {};
}

/// With the deep-cell test at a depth of a cell or more, what a remodel leaves calls for nothing
/// more: the sides of nodes have stayed, so mixed cells have, and what was near them still is.
/// (With the plain test or depth 0, cells that are complex without an event may be re-sampled
/// again: a known limit.) A node within rounding of the surface may have changed its side. Another
/// known limit: copies of bodies are dropped all or none, so those that something else kept may be
/// dropped once that is re-sampled.
Objection check_settled(const Observation& o) {
  if (o.surgery == nullptr || o.moved || o.options.cell_test != CellTest::deep ||
      o.options.depth < 1 || jitters(o) || !committed(o) || o.surgery->region.empty())
    return {};
  const Lattice lattice = lattice_of(o.before.positions, o.options);
  const surgery::Rounding rounding(o.before, lattice);
  for (const Index3& node : corners_of(o.surgery->region, o.options.depth))
    if (rounding.reaches(node)) return {};
  return fmt::format("a second remodel changed the surface, {} cells marked",
                     o.surgery->marked.total());
}

/// The winding that marches count is the solid angle over 4π, at nodes that are not near the
/// surface: there the angle is smooth, and known to more digits than asked for.
Objection check_solid_angle(const Observation& o) {
  if (o.surgery == nullptr || o.after.triangles.empty()) return {};
  const Lattice lattice = lattice_of(o.after.positions, o.options);
  const SurfaceCheck check(o.after, lattice);
  const SurfaceDistance distance(o.after, exactly(o.options));
  const auto& nodes = distance.surface_nodes();
  const double scale = std::max(
      o.options.cell_size, 0x1p-40 * bounding_box(o.after.positions).high.cwiseAbs().maxCoeff());
  Random random(o.seed);
  for (int sample = 0; sample < 12 && !nodes.empty(); ++sample) {
    const Index3 node = nodes[random.below(nodes.size())];
    if (!(std::abs(distance.at(node)) > 0x1p-10 * scale)) continue;
    const auto objection = compare_winding(o.after, lattice, {node, check.winding(node)});
    if (objection) return objection;
  }
  return {};
}

Objection compare_winding(const Triangles& surface, const Lattice& lattice,
                          const NodeWinding& claim) {
  const double angle = solid_angle(surface, lattice.node(claim.node));
  if (std::abs(angle - claim.winding) < 0.01) return {};
  return fmt::format("{} has winding {} but solid angle {}", name_of(claim.node), claim.winding,
                     angle);
}

}  // namespace suture::sims
