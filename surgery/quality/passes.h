// The passes of mesh improvement over the whole mesh [§6.2]; `improve` puts them in order.
#pragma once

#include <algorithm>

#include "surgery/collapse/edge_collapse.h"
#include "surgery/model/options.h"
#include "surgery/quality/shape.h"

namespace suture::surgery {

/// A feature smaller than this many times the shortest edge is below what the mesh resolves: it may
/// go if no other way is left to be rid of a short edge. Without it, creases that a flow folds into
/// the mesh would pile up for ever.
inline constexpr double kFeatureScale = 0.5;

/// A triangle lower than this × edge_length counts as a sliver, whose normal says nothing.
inline constexpr double kSliverHeight = 1e-3;

/// One improvement, shared by its passes: the mesh, the limits in the scene's unit, the counts.
struct Improvement {
  Mesh& mesh;
  const QualityOptions& options;
  CollapseRules rules;
  double longest, shortest;  ///< lengths
  double sin_smallest_angle, cos_largest_angle;
  QualityReport& report;
  /// Factor of the lengths at each vertex: below 1 where curvature asks for shorter edges. Not
  /// there where options.chord_error is 0.
  Mesh::Property_map<Mesh::Vertex_index, double> scales{};

  /// The lesser factor of an edge's ends.
  double scale(Mesh::Halfedge_index h) const {
    return options.chord_error > 0 ? std::min(scales[mesh.source(h)], scales[mesh.target(h)]) : 1;
  }
  /// The rules at an edge, whose bounds go with the lengths there.
  CollapseRules rules_at(Mesh::Halfedge_index h) const;
};

/// Sets improvement.scales by the curvature at each vertex. \pre options.chord_error > 0
void set_scales(Improvement& improvement);

/// Whether an angle is out of bounds.
bool is_bad(const Shape& shape, const Improvement& improvement);

/// Splits the edge of `h` at `at` and the two triangles beside it. \return the new vertex
Mesh::Vertex_index split_edge(Mesh& mesh, Mesh::Halfedge_index h, const Point& at);
/// The change that split_edge would be.
LocalChange split_change(const Mesh& mesh, Mesh::Halfedge_index h, const Point& at);

/// The point on the surface over source + part × (target − source), by options.subdivision; over
/// features, whose vertex normals mean nothing, that point itself.
Point surface_point(const Improvement& improvement, Mesh::Halfedge_index h, double part);

/// Each splits, collapses or flips what is too long, too short or bad, and returns how often.
std::size_t subdivide_long_edges(Improvement& improvement);
std::size_t collapse_short_edges(Improvement& improvement);
std::size_t flip_bad_edges(Improvement& improvement);
/// Bad triangles with an obtuse angle that no flip mends: the obtuse corner is put onto its longest
/// edge.
std::size_t flatten_caps(Improvement& improvement);

}  // namespace suture::surgery
