// The order of the paper's steps, and the transaction round them [§5, §6].
#include "surgery/remodel.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <numbers>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/lists.h"
#include "kernel/measure/measures.h"
#include "surgery/collapse/local_change.h"
#include "surgery/collapse/paper_order.h"
#include "surgery/collapse/straighten.h"
#include "surgery/detect/budget.h"
#include "surgery/detect/complex_cells.h"
#include "surgery/detect/deep_cells.h"
#include "surgery/detect/invariance.h"
#include "surgery/detect/region.h"
#include "surgery/model/jitter.h"
#include "surgery/model/tracker_lattice.h"
#include "surgery/operate/coincident.h"
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

/// What detection found; everything that cut and fill read.
struct Detected {
  Incidence mesh;
  Lattice lattice;
  Crossings crossings;
  Winding winding;
  CellSet cells;
  Region region;
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
    for_each_cell(d.mesh, d.crossings, t, [&](LatticeId cell) { touches |= near.contains(cell); });
    if (touches) triangles.push_back(t);
  }
  return triangles;
}

struct Candidate {
  Mesh mesh;
  Origins origins;
  std::vector<LatticeId> gridlocked;  ///< cells that the region must take in first [§6.2]
};

/// Adds the sites of the fill to those of the cut and places them. \return all arcs of the region
std::vector<Arc> place_fill(std::vector<Arc> boundary, const Surface& surface, const Detected& d,
                            Placement placement, Sites& sites) {
  std::vector<Arc> arcs = gather_arcs(std::move(boundary), d.region, d.winding, sites);
  const DistanceField distance(
      surface.triangles, d.lattice, d.winding,
      placement == Placement::distance_field ? triangles_near(d) : std::vector<std::uint32_t>{});
  place_isosurface(placement, d.crossings, d.winding, d.lattice, distance, sites);
  return arcs;
}

void report_surgery(const CutMesh& cut, const Patch& patch, const StitchedVertices& made,
                    SurgeryReport& report) {
  report.type1_vertices = made.type1.size();
  report.type2_vertices = made.type2.size();
  report.isosurface_vertices = made.isosurface.size();
  report.centroid_vertices = patch.centroids;
  report.loops = patch.loops;
  report.triangles_removed = cut.touched.size();
  report.triangles_added = cut.kept.size() + patch.triangles.size();
  report.split_triangles = cut.split_triangles;
}

/// Cut, fill, stitch and collapse on a copy of the mesh, in the order that the options choose.
Candidate operate(const Surface& surface, const Detected& d, Pieces pieces,
                  const TrackerOptions& options, const Oracle& oracle, SurgeryReport& report,
                  StageClock& clock) {
  const bool paper = options.collapse == Collapse::paper;
  const CollapseRules rules{&d.lattice, &oracle,
                            std::cos(options.straighten_turn * std::numbers::pi / 180)};
  Sites sites(d.mesh, d.lattice, d.crossings, d.winding, d.region, options.arithmetic);
  CutMesh cut_mesh = cut({d.mesh, d.lattice, oracle, d.crossings, d.region},
                         {pieces, paper ? Inside::made : Inside::dropped}, sites);
  clock.ended("cut");
  Candidate result{surface.mesh, {}, {}};
  result.origins = track_origins(result.mesh);
  Sewing sewing(result.mesh, sites, result.origins);
  if (paper) {
    OpenedMesh opened = open_in_paper_order(result.mesh, cut_mesh, sites, sewing, rules);
    clock.ended("collapse");
    add_to(report.collapses, opened.collapses);
    report.bent_arcs += opened.bent_arcs;
    result.gridlocked = std::move(opened.gridlocked);
    if (!result.gridlocked.empty()) return result;
    cut_mesh.boundary = std::move(opened.boundary);
  }
  const std::vector<Arc> arcs = place_fill(cut_mesh.boundary, surface, d, options.placement, sites);
  clock.ended("distance");
  const Patch patch = fill(arcs, sites);
  clock.ended("fill");
  if (paper) {
    sewing.add({&patch.triangles});
  } else {
    sewing.remove(cut_mesh.touched);
    sewing.add({&cut_mesh.kept, &patch.triangles});
  }
  clock.ended("stitch");
  report_surgery(cut_mesh, patch, sewing.made(), report);
  if (options.collapse == Collapse::straighten) {
    report.collapses = straighten(result.mesh, sewing.made().type2, sewing.made().type1, rules);
    clock.ended("straighten");
  }
  if (!paper)
    report.bent_arcs = bent_arcs(chains_of(cut_mesh.boundary, sites), result.mesh, sewing);
  return result;
}

/// The same until nothing is gridlocked: each time the region grows by the cells across from bent
/// arcs, and surgery starts again from the uncut mesh [§6.2]. \throw InternalFailure after too many
Candidate operate_and_regrow(const Surface& surface, Detected& d, Pieces pieces,
                             const TrackerOptions& options, const Oracle& oracle,
                             SurgeryReport& report, StageClock& clock) {
  for (int restarts = 0;; ++restarts) {
    Candidate candidate = operate(surface, d, pieces, options, oracle, report, clock);
    if (candidate.gridlocked.empty()) return candidate;
    if (restarts == options.most_restarts)
      throw InternalFailure("collapse", "gridlock: arcs are bent still after " +
                                            std::to_string(restarts) + " restarts");
    std::vector<LatticeId> seeds = d.region.cells.keys();
    seeds.insert(seeds.end(), candidate.gridlocked.begin(), candidate.gridlocked.end());
    const std::size_t before = d.region.cells.size();
    d.region = grow_region(seeds, d.cells);
    report.marked.gridlocked += d.region.cells.size() - before;
    ++report.regrowths;
  }
}

/// The region to be re-sampled; empty where topology stays as it is.
Region detect_region(const CellSet& cells, const Winding& winding, const TrackerOptions& options,
                     SurgeryReport& report) {
  report.surface_cells = cells.cells.size();
  report.complex_cells = cells.complex_count();
  const std::vector<LatticeId> seeds = find_events(
      cells, winding, {options.events, options.cell_test, options.depth}, report.marked);
  Region region = grow_region(seeds, cells);
  report.marked.flooded = region.cells.size() - seeds.size();
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

/// What the audit has against a new surface; empty where it is closed, oriented, manifold and
/// finite, and no winding outside the region has changed.
std::string objection(const Surface& before, const Adopted& after, const Detected& d,
                      const Oracle& oracle) {
  const Audit result = audit(after.surface.triangles);
  if (!result.closed_manifold()) return "audit: " + result.first;
  const std::vector<Index3> changed =
      changed_outside(difference(before.triangles, after.surface.triangles, after.triangle_origin,
                                 after.vertex_map),
                      d.lattice, oracle, d.region, d.winding);
  if (changed.empty()) return {};
  // An inserted vertex is off its triangle by half a bit of each coordinate: a node that lies on
  // the surface, or within a few bits of it, may find itself on the other side.
  constexpr double kRounding = 0x1p-48;
  const Box box = bounding_box(before.triangles.positions);
  const double reach =
      kRounding * std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  const DistanceField distance(before.triangles, d.lattice, d.winding);
  for (const Index3& node : changed)
    if (!(std::abs(distance.at(node)) <= reach))
      return "audit: the winding of node " + std::to_string(node[0]) + " " +
             std::to_string(node[1]) + " " + std::to_string(node[2]) +
             ", outside the region, has changed";
  return {};
}

/// What the audit's winding test asks: exact even where the surgery was not, since what it judges
/// lies on the lattice's planes and lines, where plain doubles fail. Null: the surgery's own will
/// do.
std::unique_ptr<Oracle> judge_for(const TrackerOptions& options) {
  return options.arithmetic == Arithmetic::rounded ? make_filtered_oracle() : nullptr;
}

/// Merged pieces first; if the audit ever objects, once more cell by cell; then refusal.
void attempt(Surface& surface, Detected d, const TrackerOptions& options, const Oracle& oracle,
             SurgeryReport& report, StageClock& clock) {
  const std::unique_ptr<Oracle> judge = judge_for(options);
  for (const Pieces pieces : {Pieces::merged, Pieces::cell_by_cell}) {
    try {
      Candidate candidate = operate_and_regrow(surface, d, pieces, options, oracle, report, clock);
      Adopted adopted = adopt(std::move(candidate.mesh), candidate.origins);
      adopted.vertex_map.resize(surface.triangles.positions.size(), kNone);
      report.failure = objection(surface, adopted, d, judge ? *judge : oracle);
      clock.ended("audit");
      if (report.failure.empty()) {
        surface = std::move(adopted.surface);
        report.vertex_map = std::move(adopted.vertex_map);
        report.region = d.region.cells.keys();
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

/// Detection and, where it finds an event, surgery. \pre not empty
void detect_and_operate(Surface& surface, const TrackerOptions& options, const Oracle& oracle,
                        SurgeryReport& report, StageClock& clock) {
  Incidence mesh = incidence(surface.triangles);
  Lattice lattice = tracker_lattice(surface.triangles.positions, options);
  require_crossings_fit(surface.triangles, lattice);
  clock.ended("incidence");
  Crossings crossings = find_crossings(mesh, lattice, oracle);
  report.crossings = crossings.size();
  clock.ended("crossings");
  Winding winding(crossings);
  clock.ended("winding");
  CellSet cells = find_complex_cells(crossings, winding);
  Region region = detect_region(cells, winding, options, report);
  clock.ended("detection");
  if (region.empty()) return;
  attempt(surface,
          {std::move(mesh), std::move(lattice), std::move(crossings), std::move(winding),
           std::move(cells), std::move(region)},
          options, oracle, report, clock);
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

/// Remodels what is left once exact copies of bodies are gone, and commits both or neither. \return
/// whether it could: not where a side depends on how many copies there are
bool operate_on_one_of_each(Surface& surface, const std::vector<std::uint32_t>& repeated,
                            const TrackerOptions& options, const Oracle& oracle,
                            SurgeryReport& report, StageClock& clock) {
  Surface single = surface;
  std::vector<std::uint32_t> map = drop(repeated, single);
  const Lattice lattice = tracker_lattice(surface.triangles.positions, options);
  require_crossings_fit(surface.triangles, lattice);
  const bool may_drop =
      sides_agree(single.triangles, only(repeated, surface.triangles), lattice, oracle);
  clock.ended("coincident");
  if (!may_drop) return false;
  detect_and_operate(single, options, oracle, report, clock);
  if (report.outcome == Outcome::refused) return true;
  if (report.outcome == Outcome::committed)
    for (std::uint32_t& v : map) v = v == kNone ? kNone : report.vertex_map[v];
  surface = std::move(single);
  report.vertex_map = std::move(map);
  report.coincident_triangles = repeated.size();
  report.outcome = Outcome::committed;
  return true;
}

/// \pre not empty
SurgeryReport remodel_as_it_is(Surface& surface, const TrackerOptions& options,
                               const Oracle& oracle, Trace* trace) {
  SurgeryReport report;
  const std::size_t vertices = surface.triangles.positions.size();
  StageClock clock(report, trace);
  const Components bodies = measure_before(surface, report);
  clock.ended("measure");
  const OracleCounts asked = oracle.counts();
  try {
    const std::vector<std::uint32_t> repeated = merges(options.events)
                                                    ? repeated_triangles(surface.triangles, bodies)
                                                    : std::vector<std::uint32_t>{};
    if (repeated.empty() ||
        !operate_on_one_of_each(surface, repeated, options, oracle, report, clock))
      detect_and_operate(surface, options, oracle, report, clock);
  } catch (const InternalFailure& failure) {
    report.outcome = Outcome::refused;
    report.failure = failure.what();
  }
  const OracleCounts& now = oracle.counts();
  report.oracle = {now.edge_side - asked.edge_side, now.triangle_side - asked.triangle_side,
                   now.orientation - asked.orientation,
                   now.filter_failures - asked.filter_failures};
  if (report.outcome == Outcome::committed) {
    measure_after(surface, report);
    clock.ended("measure");
  } else {
    report.vertex_map = identity_map(vertices);
  }
  return report;
}

}  // namespace

SurgeryReport remodel(Surface& surface, const TrackerOptions& options, const Oracle& oracle,
                      Trace* trace) {
  if (surface.triangles.triangles.empty()) return {};  // all of the material has gone
  if (!jitters(options)) return remodel_as_it_is(surface, options, oracle, trace);
  Surface moved = jittered(surface, options);
  SurgeryReport report = remodel_as_it_is(moved, options, oracle, trace);
  if (report.outcome == Outcome::committed) surface = std::move(moved);
  return report;
}

}  // namespace suture::surgery
