// The order of the paper's steps, and the transaction round them [§5, §6].
#include "surgery/remodel.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/lists.h"
#include "kernel/measure/measures.h"
#include "surgery/check/vanished.h"
#include "surgery/collapse/paper_order.h"
#include "surgery/collapse/straighten.h"
#include "surgery/detect/coincident.h"
#include "surgery/detect/complex_cells.h"
#include "surgery/detect/deep_cells.h"
#include "surgery/detect/distance_field.h"
#include "surgery/detect/invariance.h"
#include "surgery/detect/region.h"
#include "surgery/detect/rounding.h"
#include "surgery/detect/zones.h"
#include "surgery/operate/cut.h"
#include "surgery/operate/fill.h"
#include "surgery/operate/placement.h"
#include "surgery/operate/stitch.h"

namespace suture::surgery {

namespace {

/// Books the seconds of each stage in the report and tells whoever listens.
class StageClock {
 public:
  StageClock(SurgeryReport& report, Trace* trace) : report_(report), trace_(trace) {}
  void ended(const char* stage) {
    const double seconds = watch_.lap();
    report_.seconds.emplace_back(stage, seconds);
    if (trace_) trace_->stage_ended(stage, seconds);
  }

 private:
  SurgeryReport& report_;
  Trace* trace_;
  Stopwatch watch_;
};

/// One remodel of one surface, as all its steps see it.
struct Pass {
  Surface& surface;  ///< changed by a commit only
  const TrackerOptions& options;
  const Oracle& oracle;
  SurgeryReport& report;
  StageClock& clock;
};

/// The findings of detection with all that they refer to.
struct Findings {
  Incidence mesh;
  Lattice lattice;
  Crossings crossings;
  Winding winding;
  CellSet cells;
  Region region;

  /// The findings for those that operate, who ask `oracle`.
  Detected seen_by(const Oracle& oracle) const {
    return {mesh, {lattice, oracle}, crossings, winding, region};
  }
};

/// Triangles that touch a cell of the region or one beside it: all that D near the region can need.
std::vector<std::uint32_t> triangles_near(const Detected& d) {
  SparseField<char> near;
  for (const LatticeId cell : d.region.cells.keys())
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) near.index(step(step(step(cell, 0, i), 1, j), 2, k));
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < d.mesh.triangles.size(); ++t) {
    bool touches = false;
    for_each_cell(d.crossed(), t, [&](LatticeId cell) { touches |= near.contains(cell); });
    if (touches) triangles.push_back(t);
  }
  return triangles;
}

/// A surface after surgery that no audit has seen yet.
struct Candidate {
  Mesh mesh;
  Origins origins;
  std::vector<LatticeId> gridlocked;  ///< cells that the region must take in first [§6.2]
};

/// Adds the sites of the fill to those of the cut and places them. \return all arcs of the region
std::vector<Arc> place_fill(std::vector<Arc> boundary, Sites& sites, const Pass& pass) {
  std::vector<Arc> arcs = gather_arcs(std::move(boundary), sites);
  const Detected& d = sites.detected();
  DistanceField distance(pass.surface.triangles, d.on.lattice, d.winding);
  if (pass.options.placement == Placement::distance_field) distance.search_first(triangles_near(d));
  place_isosurface(pass.options.placement, distance, sites);
  return arcs;
}

void count_triangles(const CutMesh& cut, const Patch& patch, SurgeryReport& report) {
  report.centroid_vertices = patch.centroids;
  report.loops = patch.loops;
  report.triangles_removed = cut.touched.size();
  report.triangles_added = cut.kept.size() + patch.triangles.size();
  report.split_triangles = cut.split_triangles;
}

void count_vertices(const StitchedVertices& made, SurgeryReport& report) {
  report.type1_vertices = made.type1.size();
  report.type2_vertices = made.type2.size();
  report.isosurface_vertices = made.isosurface.size();
}

/// Cut, fill, stitch and collapse on a copy of the mesh, in the order that the options choose.
Candidate operate(const Findings& found, Pieces pieces, const Pass& pass) {
  const Detected d = found.seen_by(pass.oracle);
  const bool paper = pass.options.collapse == Collapse::paper;
  const CollapseRules rules{&d.on, std::cos(pass.options.straighten_turn * std::numbers::pi / 180)};
  Sites sites(d, pass.options.arithmetic);
  CutMesh cut_mesh = cut({pieces, paper ? Inside::made : Inside::dropped}, sites);
  pass.clock.ended("cut");
  Candidate result{pass.surface.mesh, {}, {}};
  result.origins = track_origins(result.mesh);
  Sewing sewing(result.mesh, sites, result.origins);
  if (paper) {
    OpenedMesh opened = open_in_paper_order(cut_mesh, sewing, rules);
    pass.clock.ended("collapse");
    add_to(pass.report.collapses, opened.collapses);
    pass.report.bent_arcs += opened.bent_arcs;
    result.gridlocked = std::move(opened.gridlocked);
    if (!result.gridlocked.empty()) return result;
    cut_mesh.boundary = std::move(opened.boundary);
  }
  const std::vector<Arc> arcs = place_fill(cut_mesh.boundary, sites, pass);
  pass.clock.ended("distance");
  const Patch patch = fill(arcs, sites);
  pass.clock.ended("fill");
  if (paper) {
    sewing.add({&patch.triangles});
  } else {
    sewing.remove(cut_mesh.touched);
    sewing.add({&cut_mesh.kept, &patch.triangles});
  }
  pass.clock.ended("stitch");
  count_triangles(cut_mesh, patch, pass.report);
  count_vertices(sewing.made(), pass.report);
  if (pass.options.collapse == Collapse::straighten) {
    pass.report.collapses = straighten(result.mesh, sewing.made(), rules);
    pass.clock.ended("straighten");
  }
  if (!paper) pass.report.bent_arcs = bent_arcs(chains_of(cut_mesh.boundary, sites), sewing);
  return result;
}

/// The same until nothing is gridlocked: each time the region grows by the cells across from bent
/// arcs, and surgery starts again from the uncut mesh [§6.2]. \throw InternalFailure after too many
Candidate operate_and_regrow(Findings& found, Pieces pieces, const Pass& pass) {
  for (int restarts = 0;; ++restarts) {
    Candidate candidate = operate(found, pieces, pass);
    if (candidate.gridlocked.empty()) return candidate;
    if (restarts == pass.options.most_restarts)
      throw InternalFailure("collapse", "gridlock: arcs are bent still after " +
                                            std::to_string(restarts) + " restarts");
    std::vector<LatticeId> seeds = found.region.cells.keys();
    seeds.insert(seeds.end(), candidate.gridlocked.begin(), candidate.gridlocked.end());
    const std::size_t before = found.region.cells.size();
    found.region = grow_over_zones(grow_region(seeds, found.cells),
                                   {found.cells, found.winding, pass.options.events});
    pass.report.marked.gridlocked += found.region.cells.size() - before;
    ++pass.report.regrowths;
  }
}

/// The region to be re-sampled; empty where topology stays as it is.
Region detect_region(const CellSet& cells, const Winding& winding, const Pass& pass) {
  const TrackerOptions& options = pass.options;
  pass.report.surface_cells = cells.cells.size();
  pass.report.complex_cells = cells.complex_count();
  const EventCells seeds =
      find_events(cells, winding, {options.events, options.cell_test, options.depth});
  Region region = grow_region(seeds.cells, cells);
  pass.report.marked = seeds.marked;
  pass.report.marked.flooded = region.cells.size() - seeds.cells.size();
  const std::size_t before = region.cells.size();
  region = grow_over_zones(std::move(region), {cells, winding, options.events});
  pass.report.marked.overlapped = region.cells.size() - before;
  return region;
}

Components measure_before(const Surface& surface, SurgeryReport& report) {
  Components bodies = components(surface.triangles);
  report.volume_before = report.volume_after = volume(surface.triangles);
  report.euler_before = report.euler_after = euler_characteristic(surface.triangles);
  report.components_before = report.components_after = bodies.count;
  return bodies;
}

void measure_after(const Surface& surface, SurgeryReport& report) {
  report.volume_after = volume(surface.triangles);
  report.euler_after = euler_characteristic(surface.triangles);
  report.components_after = components(surface.triangles).count;
}

/// The oracle that the audit's winding test asks: an exact one even where the surgery's was not,
/// since the new vertices lie on the lattice's planes and lines, where plain doubles fail. Null:
/// the surgery's own will do.
std::unique_ptr<Oracle> judge_for(const TrackerOptions& options) {
  return options.arithmetic == Arithmetic::rounded ? make_filtered_oracle() : nullptr;
}

/// The nodes whose side has changed, or a winding of 0 or 1.
std::vector<Index3> changed_nodes(const Adopted& after, const Findings& found, const Pass& pass) {
  const std::unique_ptr<Oracle> judge = judge_for(pass.options);
  std::optional<OracleTally> apart;  // the judge's questions are not the surgery's
  if (judge) apart.emplace();
  const Triangles change = difference(pass.surface.triangles, after.surface.triangles,
                                      {after.triangle_origin, after.vertex_map});
  return wrongly_changed(change, found.seen_by(judge ? *judge : pass.oracle));
}

/// The audit's objection to a new surface; empty where it is closed, oriented, manifold and finite,
/// and no node has changed its side, but for those that the surface meets within rounding.
std::string objection(const Adopted& after, const Findings& found, const Pass& pass) {
  const Audit result = audit(after.surface.triangles);
  if (!result.closed_manifold()) return "audit: " + result.first;
  const std::vector<Index3> changed = changed_nodes(after, found, pass);
  if (changed.empty()) return {};
  const Rounding rounding(pass.surface.triangles, found.lattice);
  for (const Index3& node : changed)
    if (!rounding.reaches(node))
      return "audit: the winding of node " + std::to_string(node[0]) + " " +
             std::to_string(node[1]) + " " + std::to_string(node[2]) + " has changed";
  return {};
}

/// Merged pieces first; if the audit ever objects, once more cell by cell; then refusal.
void attempt(Findings found, const Pass& pass) {
  SurgeryReport& report = pass.report;
  for (const Pieces pieces : {Pieces::merged, Pieces::cell_by_cell}) {
    try {
      Candidate candidate = operate_and_regrow(found, pieces, pass);
      Adopted adopted = adopt(std::move(candidate.mesh), candidate.origins);
      adopted.vertex_map.resize(pass.surface.triangles.positions.size(), kNone);
      report.failure = objection(adopted, found, pass);
      pass.clock.ended("audit");
      if (report.failure.empty()) {
        report.vanished = vanished_bodies(
            {pass.surface.triangles, adopted.surface.triangles, adopted.vertex_map});
        pass.surface = std::move(adopted.surface);
        report.vertex_map = std::move(adopted.vertex_map);
        report.region = found.region.cells.keys();
        report.outcome = Outcome::committed;
        return;
      }
    } catch (const InternalFailure& failure) {
      report.failure = failure.what();
    }
    if (pieces == Pieces::merged) ++report.recuts;
  }
  report.outcome = Outcome::refused;
}

/// The tracker's lattice round the surface. \throw InvalidInput if their crossings would not fit
Lattice fitting_lattice(const Pass& pass) {
  Lattice lattice = tracker_lattice(pass.surface.triangles.positions, pass.options);
  require_crossings_fit(pass.surface.triangles, lattice);
  return lattice;
}

/// Detection and, where it finds an event, surgery. \pre not empty
void detect_and_operate(const Pass& pass) {
  Incidence mesh = incidence(pass.surface.triangles);
  Lattice lattice = fitting_lattice(pass);
  pass.clock.ended("incidence");
  Crossings crossings = find_crossings(mesh, {lattice, pass.oracle});
  pass.report.crossings = crossings.size();
  pass.clock.ended("crossings");
  Winding winding(crossings);
  pass.clock.ended("winding");
  CellSet cells = find_complex_cells(crossings, winding);
  Region region = detect_region(cells, winding, pass);
  pass.clock.ended("detection");
  if (region.empty()) return;
  attempt({std::move(mesh), std::move(lattice), std::move(crossings), std::move(winding),
           std::move(cells), std::move(region)},
          pass);
}

/// The surface without some of its triangles, whole components of them. \return old vertex → new
std::vector<std::uint32_t> drop(const std::vector<std::uint32_t>& triangles, Surface& surface) {
  surface.mesh.set_recycle_garbage(false);
  const Origins origins = track_origins(surface.mesh);
  for (const std::uint32_t t : triangles)
    CGAL::Euler::remove_face(surface.mesh.halfedge(Mesh::Face_index(t)), surface.mesh);
  const std::size_t vertices = surface.triangles.positions.size();
  Adopted adopted = adopt(std::move(surface.mesh), origins);
  surface = std::move(adopted.surface);
  adopted.vertex_map.resize(vertices, kNone);
  return std::move(adopted.vertex_map);
}

Triangles only(const std::vector<std::uint32_t>& triangles, const Triangles& surface) {
  Triangles some{surface.positions, {}};
  for (const std::uint32_t t : triangles) some.triangles.push_back(surface.triangles[t]);
  return some;
}

/// Remodels the surface without exact copies of bodies, and commits that and their loss or neither.
/// \return whether it could: not where a side depends on how many copies there are
bool operate_on_one_of_each(const std::vector<std::uint32_t>& repeated, const Pass& pass) {
  SurgeryReport& report = pass.report;
  Surface single = pass.surface;
  std::vector<std::uint32_t> map = drop(repeated, single);
  const Lattice lattice = fitting_lattice(pass);
  const bool may_drop =
      sides_agree(single.triangles, only(repeated, pass.surface.triangles), {lattice, pass.oracle});
  pass.clock.ended("coincident");
  if (!may_drop) return false;
  detect_and_operate({single, pass.options, pass.oracle, report, pass.clock});
  if (report.outcome == Outcome::refused) return true;
  if (report.outcome == Outcome::committed)
    for (std::uint32_t& v : map) v = v == kNone ? kNone : report.vertex_map[v];
  pass.surface = std::move(single);
  report.vertex_map = std::move(map);
  report.coincident_triangles = repeated.size();
  report.outcome = Outcome::committed;
  return true;
}

/// \pre not empty
SurgeryReport remodel_as_it_is(Surface& surface, const Setup& setup) {
  SurgeryReport report;
  const std::size_t vertices = surface.triangles.positions.size();
  StageClock clock(report, setup.trace);
  const Pass pass{surface, setup.options, setup.oracle, report, clock};
  const Components bodies = measure_before(surface, report);
  clock.ended("measure");
  const OracleTally tally;
  try {
    const std::vector<std::uint32_t> repeated = merges(setup.options.events)
                                                    ? repeated_triangles(surface.triangles, bodies)
                                                    : std::vector<std::uint32_t>{};
    if (repeated.empty() || !operate_on_one_of_each(repeated, pass)) detect_and_operate(pass);
  } catch (const InternalFailure& failure) {
    report.outcome = Outcome::refused;
    report.failure = failure.what();
  }
  report.oracle = tally.counts();
  if (report.outcome == Outcome::committed) {
    measure_after(surface, report);
    clock.ended("measure");
  } else {
    report.vertex_map = identity_map(vertices);
  }
  return report;
}

}  // namespace

SurgeryReport remodel(Surface& surface, const Setup& setup) {
  if (surface.triangles.triangles.empty()) return {};  // all of the material has gone
  if (!jitters(setup.options)) return remodel_as_it_is(surface, setup);
  Surface moved = jittered(surface, setup.options);
  SurgeryReport report = remodel_as_it_is(moved, setup);
  if (report.outcome == Outcome::committed) surface = std::move(moved);
  return report;
}

}  // namespace suture::surgery
