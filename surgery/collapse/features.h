// Sharp edges and corners hold their vertices in place [§6.2].
#pragma once

#include "surgery/collapse/local_change.h"

namespace suture::surgery {

/// A vertex is on no feature; on a crease that passes through it nearly straight; or on a corner, a
/// crease's end or a sharp turn of it, any of which must stay.
enum class VertexKind { free, crease, corner };

Corners corners(const Mesh& mesh, Mesh::Face_index f);

/// Unit normal; for a sliver that of the face across its longest edge; zero where that is one too.
Point reliable_normal(const Mesh& mesh, Mesh::Face_index f, double sliver_height);

/// Whether the normals at `e` differ by more than rules.cos_feature says.
bool is_feature(const Mesh& mesh, Mesh::Edge_index e, const CollapseRules& rules);

/// A crease is nearly straight where it turns by less than the feature angle.
VertexKind vertex_kind(const Mesh& mesh, Mesh::Vertex_index v, const CollapseRules& rules);

/// Whether moving the source of `h` to its target takes it off a corner or a crease.
bool leaves_feature(const Mesh& mesh, Mesh::Halfedge_index h, const CollapseRules& rules);

}  // namespace suture::surgery
