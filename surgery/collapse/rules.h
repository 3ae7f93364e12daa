// When a local operation is allowed: topology, orientation, lattice nodes, volume, features [§6.2].
#pragma once

#include "kernel/lattice.h"
#include "kernel/mesh.h"
#include "predicates/oracle.h"

namespace suture::surgery {

/// Why an operation was refused, or `none`. `premature`: it would join two type 1 vertices before
/// the arc between them is due [§6.2].
enum class Refusal { none, link, normal, node, volume, feature, premature };

/// The limits of one operation; lengths and volumes in the scene's unit.
struct CollapseRules {
  const Lattice* lattice = nullptr;  ///< null: lattice nodes may be swept
  const Oracle* oracle = nullptr;    ///< needed with a lattice
  double cos_turn = 0.5;             ///< cosine of the most a normal may turn
  double volume_bound = 1e300;       ///< most volume that may be moved
  double cos_feature = -2;   ///< edges whose normals' cosine is below it are features; -2: none are
  double sliver_height = 0;  ///< a triangle no higher than this has no normal worth keeping
};

/// Whether the source of `h` may be collapsed onto its target, which stays where it is.
/// Rules in order: link condition (and no component may vanish); no triangle turned over, or turned
/// by more than the bound; no node of the shifted lattice swept; volume (the sum of the absolute
/// volumes of the swept tetrahedra); features. A sliver's own normal says nothing: it may turn as
/// it likes while it stays a sliver, and if it grows it must face the way its star does.
Refusal may_collapse(const Mesh& mesh, Mesh::Halfedge_index h, const CollapseRules& rules);

/// The same for a collapse after which the target stands at `to`. A vertex on a feature may not
/// move, so `to` must then be where the target is.
Refusal may_collapse_to(const Mesh& mesh, Mesh::Halfedge_index h, const Point& to,
                        const CollapseRules& rules);

/// Collapses the source of `h` onto its target. \pre may_collapse gave Refusal::none
/// \return the vertex that stays: always the target of `h`, with its index and position
Mesh::Vertex_index collapse(Mesh& mesh, Mesh::Halfedge_index h);

/// Whether moving vertex `v` to `to` sweeps a node of the shifted lattice: some tetrahedron
/// (v, to, a, b) over the triangles (v, a, b) of its star contains one.
bool sweeps_node(const Mesh& mesh, Mesh::Vertex_index v, const Point& to, const Lattice& lattice,
                 const Oracle& oracle);

/// Whether a node of the shifted lattice lies in the tetrahedron; false where it has no volume.
bool holds_node(const Point& a, const Point& b, const Point& c, const Point& d,
                const Lattice& lattice, const Oracle& oracle);

}  // namespace suture::surgery
