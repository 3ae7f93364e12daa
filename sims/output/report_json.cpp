// Reports as JSON: what a remodel, an improvement or a step did.
#include "sims/output/report_json.h"

#include <nlohmann/json.hpp>

#include "kernel/measure/measures.h"
#include "sims/fluid/frame.h"
#include "surgery/model/option_table.h"

namespace suture::sims {
namespace {

using nlohmann::json;

constexpr std::array<Named<Outcome>, 3> kOutcomeNames = {{{"unchanged", Outcome::unchanged},
                                                          {"committed", Outcome::committed},
                                                          {"refused", Outcome::refused}}};

template <class T, std::size_t N>
std::string name_of(T value, const std::array<Named<T>, N>& names) {
  for (const Named<T>& named : names)
    if (named.value == value) return named.name;
  return "unknown";
}

json to_json(const CollapseCounts& c) {
  return {{"done", c.done},
          {"delayed", c.delayed},
          {"blocked", c.blocked},
          {"refused_link", c.refused_link},
          {"refused_normal", c.refused_normal},
          {"refused_node", c.refused_node},
          {"refused_volume", c.refused_volume},
          {"refused_feature", c.refused_feature}};
}

json to_json(const MarkedCells& m) {
  return {{"deep_inside", m.deep_inside},
          {"deep_outside", m.deep_outside},
          {"self_intersecting", m.self_intersecting},
          {"inverted", m.inverted},
          {"plain", m.plain},
          {"flooded", m.flooded},
          {"overlapped", m.overlapped},
          {"gridlocked", m.gridlocked},
          {"total", m.total()}};
}

json to_json(const OracleCounts& o) {
  return {{"edge_side", o.edge_side},
          {"triangle_side", o.triangle_side},
          {"orientation", o.orientation},
          {"filter_failures", o.filter_failures}};
}

json to_json(const std::vector<VanishedBody>& bodies) {
  json all = json::array();
  for (const VanishedBody& body : bodies)
    all.push_back(
        {{"volume", body.volume}, {"centre", {body.centre[0], body.centre[1], body.centre[2]}}});
  return all;
}

/// The options of a table by their names.
template <class Options>
json to_json(const Options& options, const OptionTable<Options>& table) {
  json all = json::object();
  for (const auto& [name, value] : values(options, table))
    std::visit([&all, &key = name](const auto& v) { all[key] = v; }, value);
  return all;
}

}  // namespace

json to_json(const SurgeryReport& r, const std::string& reproducer) {
  json seconds = json::object();
  for (const auto& [stage, time] : r.seconds)  // a stage may have run more than once
    seconds[stage] = seconds.value(stage, 0.0) + time;
  return {{"outcome", name_of(r.outcome, kOutcomeNames)},
          {"failure", r.failure},
          {"reproducer", reproducer},
          {"crossings", r.crossings},
          {"surface_cells", r.surface_cells},
          {"complex_cells", r.complex_cells},
          {"marked", to_json(r.marked)},
          {"type1_vertices", r.type1_vertices},
          {"type2_vertices", r.type2_vertices},
          {"isosurface_vertices", r.isosurface_vertices},
          {"centroid_vertices", r.centroid_vertices},
          {"triangles_removed", r.triangles_removed},
          {"triangles_added", r.triangles_added},
          {"loops", r.loops},
          {"coincident_triangles", r.coincident_triangles},
          {"split_triangles", r.split_triangles},
          {"bent_arcs", r.bent_arcs},
          {"regrowths", r.regrowths},
          {"recuts", r.recuts},
          {"collapses", to_json(r.collapses)},
          {"oracle", to_json(r.oracle)},
          {"volume_before", r.volume_before},
          {"volume_after", r.volume_after},
          {"euler_before", r.euler_before},
          {"euler_after", r.euler_after},
          {"components_before", r.components_before},
          {"components_after", r.components_after},
          {"vanished", to_json(r.vanished)},
          {"seconds", std::move(seconds)}};
}

json to_json(const QualityReport& r) {
  return {{"subdivisions", r.subdivisions},     {"flips", r.flips},
          {"collapses", to_json(r.collapses)},  {"refused_flips", r.refused_flips},
          {"smallest_angle", r.smallest_angle}, {"shortest_edge", r.shortest_edge},
          {"longest_edge", r.longest_edge}};
}

json to_json(const Audit& a) {
  return {{"closed_manifold", a.closed_manifold()},
          {"closed", a.closed()},
          {"oriented", a.oriented()},
          {"edge_manifold", a.edge_manifold()},
          {"vertex_manifold", a.vertex_manifold()},
          {"finite", a.finite()},
          {"non_finite_vertices", a.non_finite_vertices},
          {"indices_out_of_range", a.indices_out_of_range},
          {"degenerate_triangles", a.degenerate_triangles},
          {"duplicate_triangles", a.duplicate_triangles},
          {"border_edges", a.border_edges},
          {"non_manifold_edges", a.non_manifold_edges},
          {"misoriented_edges", a.misoriented_edges},
          {"non_manifold_vertices", a.non_manifold_vertices},
          {"isolated_vertices", a.isolated_vertices},
          {"first", a.first}};
}

json to_json(const TrackerOptions& t) {
  json all = to_json(t, tracker_options());
  all["quality"] = to_json(t.quality, quality_options());
  return all;
}

json to_json(const TrackerCost& cost) {
  json seconds = json::object(), counts = json::object();
  for (const auto& [part, spent] : cost.seconds) seconds[part] = spent;
  for (const auto& [what, count] : cost.counts) counts[what] = count;
  return {{"seconds", seconds}, {"counts", counts}};
}

json to_json(const FluidFrame& frame) {
  const FluidStep& step = frame.worst;
  return {{"steps", frame.steps},
          {"dt", step.dt},
          {"cfl", step.cfl},
          {"cells", step.cells},
          {"liquid", step.liquid},
          {"drops", step.drops},
          {"residual", step.residual},
          {"tension_share", step.tension_share},
          {"unconverged", step.unconverged}};
}

json to_json(const std::vector<ModuleCost>& costs) {
  json modules = json::array();
  for (const ModuleCost& c : costs)
    modules.push_back({{"name", c.name},
                       {"seconds", c.seconds},
                       {"bytes", c.bytes},
                       {"calls", c.calls},
                       {"iterations", c.iterations},
                       {"residual", c.residual},
                       {"unconverged", c.unconverged}});
  return modules;
}

json measured(const Triangles& surface) {
  const EdgeLengths lengths = edge_lengths(surface);
  const Angles corner = angles(surface);
  return {{"vertices", surface.positions.size()},
          {"triangles", surface.triangles.size()},
          {"volume", volume(surface)},
          {"area", area(surface)},
          {"components", components(surface).count},
          {"euler", euler_characteristic(surface)},
          {"smallest_angle", corner.smallest},
          {"largest_angle", corner.largest},
          {"shortest_edge", lengths.shortest},
          {"mean_edge", lengths.mean},
          {"longest_edge", lengths.longest}};
}

}  // namespace suture::sims
