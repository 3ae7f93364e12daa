// What one local operation would do to the surface, and the rules that need only that [§6.2].
#pragma once

#include <Eigen/Geometry>
#include <boost/container/small_vector.hpp>

#include "surgery/collapse/rules.h"
#include "surgery/model/report.h"

namespace suture::surgery {

using Corners = std::array<Point, 3>;

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
  boost::container::small_vector<std::array<Point, 4>, 24> swept;
};

/// Sum of the absolute volumes of the swept tetrahedra: no less than the volume between the surface
/// before and after.
double volume_moved(const LocalChange& change);

/// The first of the rules on normals, nodes and volume that the change breaks.
Refusal judge(const LocalChange& change, const CollapseRules& rules);

/// One more refused for that reason; nothing for `none`.
void count_refusal(CollapseCounts& counts, Refusal refusal);

void add_to(CollapseCounts& sum, const CollapseCounts& counts);

/// Marks on faces; not 0: marked.
using FaceMarks = Mesh::Property_map<Mesh::Face_index, char>;

/// The change that collapses the source of `h` onto its target and puts that at `to`; without the
/// faces that `doomed` marks, which are about to be dropped.
LocalChange collapse_change(const Mesh& mesh, Mesh::Halfedge_index h, const Point& to,
                            const FaceMarks* doomed = nullptr);

/// Link condition of a closed triangle mesh, complete: the mesh stays a 2-manifold and no component
/// vanishes.
bool keeps_manifold(const Mesh& mesh, Mesh::Halfedge_index h);

}  // namespace suture::surgery
