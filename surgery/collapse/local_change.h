// The change that one local operation makes to the surface, judged by the rules that need only
// that [§6.2].
#pragma once

#include <Eigen/Geometry>
#include <boost/container/small_vector.hpp>

#include "kernel/mesh.h"
#include "surgery/collapse/rules.h"
#include "surgery/collapse/swept_nodes.h"

namespace suture::surgery {

/// Normal times twice the area.
inline Point area_vector(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// Distance of a triangle's longest edge from the corner opposite; `doubled_area` is |area_vector|.
double height(const Corners& t, double doubled_area);

/// One operation: each triangle that changes, before and after, and the tetrahedra that the surface
/// passes through on its way.
struct LocalChange {
  struct Pair {
    Corners before, after;
  };
  boost::container::small_vector<Pair, 24> triangles;
  boost::container::small_vector<Tetrahedron, 24> swept;
};

/// Sum of the absolute volumes of the swept tetrahedra: no less than the volume between the surface
/// before and after.
double volume_moved(const LocalChange& change);

/// The first of the rules on normals, nodes and volume that the change breaks.
Refusal judge(const LocalChange& change, const CollapseRules& rules);

/// The source of `h` goes, and its target stands at `to`.
struct EdgeCollapse {
  Mesh::Halfedge_index h;
  Point to;
};

/// Marks on faces; not 0: marked.
using FaceMarks = Mesh::Property_map<Mesh::Face_index, char>;

/// The change that the collapse makes; without the faces that `doomed` marks, which are about to be
/// dropped.
LocalChange collapse_change(const Mesh& mesh, const EdgeCollapse& collapse,
                            const FaceMarks* doomed = nullptr);

/// Link condition of a closed triangle mesh, complete: the mesh stays a 2-manifold and no component
/// vanishes.
bool keeps_manifold(const Mesh& mesh, Mesh::Halfedge_index h);

}  // namespace suture::surgery
