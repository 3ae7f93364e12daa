// The order of mesh improvement, and its report [§6.2].
#include "surgery/quality/improve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "surgery/quality/passes.h"

namespace suture::surgery {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

CollapseRules rules_for(const QualityOptions& options, const ShiftedLattice* nodes) {
  const double length = options.edge_length;
  CollapseRules rules;
  rules.nodes = nodes;
  rules.cos_turn = std::cos(options.turn_bound * kDegree);
  rules.volume_bound = options.volume_bound * length * length * length;
  rules.cos_feature = options.keep_features ? std::cos(options.feature_angle * kDegree) : -2;
  rules.sliver_height = kSliverHeight * length;
  return rules;
}

void measure(const Mesh& mesh, QualityReport& report) {
  double sine = 1, shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const auto f : mesh.faces()) sine = std::min(sine, shape_of(mesh, f).smallest_sine);
  for (const auto e : mesh.edges()) {
    const double length = length_of(mesh, mesh.halfedge(e));
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  if (mesh.number_of_faces() == 0) return;
  report.smallest_angle = std::asin(std::min(sine, 1.)) / kDegree;
  report.shortest_edge = shortest;
  report.longest_edge = longest;
}

}  // namespace

QualityReport improve(Mesh& mesh, const QualityOptions& options, const ShiftedLattice* nodes) {
  if (!(options.edge_length > 0) || !std::isfinite(options.edge_length))
    throw InvalidInput(
        "mesh improvement needs an edge length that is finite and above zero; set "
        "QualityOptions::edge_length");
  QualityReport report;
  report.vertex_map.assign(mesh.num_vertices(), kNone);
  auto before = mesh.add_property_map<Mesh::Vertex_index, std::uint32_t>("v:before", kNone).first;
  for (const auto v : mesh.vertices()) before[v] = v;

  Improvement work{mesh,
                   options,
                   rules_for(options, nodes),
                   options.longest * options.edge_length,
                   options.shortest * options.edge_length,
                   std::sin(options.smallest_angle * kDegree),
                   std::cos(options.largest_angle * kDegree),
                   report};
  const bool by_curvature = options.chord_error > 0;
  if (by_curvature)
    work.scales = mesh.add_property_map<Mesh::Vertex_index, double>("v:scale", 1).first;
  for (int pass = 0; pass < options.passes; ++pass) {
    if (by_curvature) set_scales(work);
    std::size_t done = subdivide_long_edges(work);
    done += collapse_short_edges(work);
    done += flip_bad_edges(work);
    done += flatten_caps(work);
    if (done == 0) break;
  }
  if (mesh.has_garbage()) mesh.collect_garbage();
  for (const auto v : mesh.vertices())
    if (before[v] != kNone) report.vertex_map[before[v]] = v;
  mesh.remove_property_map(before);
  if (by_curvature) mesh.remove_property_map(work.scales);
  measure(mesh, report);
  return report;
}

}  // namespace suture::surgery
