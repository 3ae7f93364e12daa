// The order of the paper's steps, and the transaction round them [§5, §6].
#include "surgery/remodel.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "kernel/audit.h"
#include "kernel/errors.h"
#include "kernel/measures.h"
#include "surgery/complex_cells.h"
#include "surgery/cut.h"
#include "surgery/deep_cells.h"
#include "surgery/fill.h"
#include "surgery/placement.h"
#include "surgery/region.h"
#include "surgery/stitch.h"
#include "surgery/straighten.h"

namespace suture {

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
  OriginMap origin;
};

/// Cut, fill, stitch and straighten on a copy of the mesh.
Candidate operate(const Surface& surface, const Detected& d, Pieces pieces,
                  const TrackerOptions& options, const Oracle& oracle, SurgeryReport& report,
                  StageClock& clock) {
  Sites sites(d.mesh, d.lattice, d.crossings, d.winding, d.region);
  const CutMesh cut_mesh = cut({d.mesh, d.lattice, oracle, d.crossings, d.region}, pieces, sites);
  clock.ended("cut");
  const std::vector<Arc> arcs = gather_arcs(cut_mesh, d.region, d.winding, sites);
  const DistanceField distance(surface.triangles, d.lattice, d.winding,
                               options.placement == Placement::distance_field
                                   ? triangles_near(d)
                                   : std::vector<std::uint32_t>{});
  place_isosurface(options.placement, d.crossings, d.winding, d.lattice, distance, sites);
  clock.ended("distance");
  const Patch patch = fill(arcs, sites);
  clock.ended("fill");

  Candidate result{surface.mesh, {}};
  result.origin = result.mesh.add_property_map<Mesh::Vertex_index, std::uint32_t>("v:origin").first;
  for (const auto v : result.mesh.vertices()) result.origin[v] = v;
  const StitchedVertices made = stitch(result.mesh, cut_mesh, patch, sites, result.origin);
  clock.ended("stitch");

  report.type1_vertices = made.type1.size();
  report.type2_vertices = made.type2.size();
  report.isosurface_vertices = made.isosurface.size();
  report.centroid_vertices = patch.centroids;
  report.loops = patch.loops;
  report.triangles_removed = cut_mesh.touched.size();
  report.triangles_added = cut_mesh.kept.size() + patch.triangles.size();
  report.split_triangles = cut_mesh.split_triangles;
  if (options.collapse == Collapse::straighten) {
    const CollapseRules rules{&d.lattice, &oracle,
                              std::cos(options.straighten_turn * std::numbers::pi / 180)};
    report.collapses = straighten(result.mesh, made.type2, made.type1, rules);
    clock.ended("straighten");
  }
  return result;
}

std::optional<Region> detect_region(const Crossings& crossings, const Winding& winding,
                                    const TrackerOptions& options, SurgeryReport& report) {
  const CellSet cells = find_complex_cells(crossings, winding);
  report.surface_cells = cells.cells.size();
  report.complex_cells = cells.complex_count();
  const std::vector<LatticeId> seeds = find_events(
      cells, winding, {options.events, options.cell_test, options.depth}, report.marked);
  if (seeds.empty()) return std::nullopt;
  Region region = grow_region(seeds, cells);
  report.marked.flooded = region.cells.size() - seeds.size();
  return region;
}

void measure_before(const Surface& surface, SurgeryReport& report) {
  report.volume_before = report.volume_after = volume(surface.triangles);
  report.euler_before = report.euler_after = euler_characteristic(surface.triangles);
  report.components_before = report.components_after = components(surface.triangles).count;
}

void measure_after(const Surface& surface, SurgeryReport& report) {
  report.volume_after = volume(surface.triangles);
  report.euler_after = euler_characteristic(surface.triangles);
  report.components_after = components(surface.triangles).count;
}

/// Merged pieces first; if the audit ever objects, once more cell by cell; then refusal.
void attempt(Surface& surface, const Detected& d, const TrackerOptions& options,
             const Oracle& oracle, SurgeryReport& report, StageClock& clock) {
  for (const Pieces pieces : {Pieces::merged, Pieces::cell_by_cell}) {
    try {
      Candidate candidate = operate(surface, d, pieces, options, oracle, report, clock);
      Surface adopted;
      report.vertex_map = adopt(adopted, std::move(candidate.mesh), candidate.origin);
      const Audit result = audit(adopted.triangles);
      clock.ended("audit");
      if (result.closed_manifold()) {
        surface = std::move(adopted);
        report.outcome = Outcome::committed;
        report.failure.clear();
        return;
      }
      report.failure = "audit: " + result.first;
    } catch (const InternalFailure& failure) {
      report.failure = failure.what();
    }
    ++report.recuts;
  }
  report.outcome = Outcome::refused;
}

}  // namespace

std::vector<std::uint32_t> adopt(
    Surface& surface, Mesh&& mesh,
    const Mesh::Property_map<Mesh::Vertex_index, std::uint32_t>& origin) {
  std::uint32_t most = 0;
  for (const auto v : mesh.vertices())
    if (origin[v] != kNone) most = std::max(most, origin[v] + 1);
  mesh.collect_garbage();
  std::vector<std::uint32_t> map(most, kNone);
  for (const auto v : mesh.vertices())
    if (origin[v] != kNone) map[origin[v]] = v;
  auto own = origin;
  mesh.remove_property_map(own);
  surface.triangles = to_triangles(mesh);
  surface.mesh = std::move(mesh);
  return map;
}

SurgeryReport remodel(Surface& surface, const TrackerOptions& options, const Oracle& oracle,
                      Trace* trace) {
  SurgeryReport report;
  StageClock clock(report, trace);
  const std::size_t vertices = surface.triangles.positions.size();
  measure_before(surface, report);
  clock.ended("measure");
  const OracleCounts asked = oracle.counts();
  try {
    Incidence mesh = incidence(surface.triangles);
    Lattice lattice = lattice_around(bounding_box(surface.triangles.positions), options.cell_size,
                                     options.origin, options.depth + 3);
    clock.ended("incidence");
    Crossings crossings = find_crossings(mesh, lattice, oracle);
    report.crossings = crossings.size();
    clock.ended("crossings");
    Winding winding(crossings);
    clock.ended("winding");
    std::optional<Region> region = detect_region(crossings, winding, options, report);
    clock.ended("detection");
    if (region)
      attempt(surface,
              {std::move(mesh), std::move(lattice), std::move(crossings), std::move(winding),
               std::move(*region)},
              options, oracle, report, clock);
  } catch (const InternalFailure& failure) {
    report.outcome = Outcome::refused;
    report.failure = failure.what();
  }
  const OracleCounts& now = oracle.counts();
  report.oracle = {now.edge_side - asked.edge_side, now.triangle_side - asked.triangle_side,
                   now.orientation - asked.orientation,
                   now.filter_failures - asked.filter_failures};
  if (report.outcome == Outcome::committed) {
    report.vertex_map.resize(vertices, kNone);
    measure_after(surface, report);
    clock.ended("measure");
  } else {
    report.vertex_map.resize(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) report.vertex_map[v] = v;
  }
  return report;
}

}  // namespace suture
