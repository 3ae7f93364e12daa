// When a local operation is allowed: topology, orientation, lattice nodes, volume, features [§6.2].
#pragma once

#include "kernel/lattice.h"
#include "kernel/mesh.h"
#include "predicates/oracle.h"

namespace suture {

/// Why an operation was refused, or `none`.
enum class Refusal { none, link, normal, node, volume, feature };

/// The limits of one operation; lengths and volumes in the scene's unit.
struct CollapseRules {
  const Lattice* lattice = nullptr;  ///< null: lattice nodes may be swept
  const Oracle* oracle = nullptr;    ///< needed with a lattice
  double cos_turn = 0.5;             ///< cosine of the most a normal may turn
  double volume_bound = 1e300;       ///< most volume that may be moved
  double cos_feature = -2;  ///< edges whose normals' cosine is below it are features; -2: none are
};

/// Whether the source of `h` may be collapsed onto its target, which stays where it is.
/// Rules in order: link condition; no new or larger normal turn beyond the bound and no triangle
/// turned over (triangles without area before are exempt); no node of the shifted lattice swept;
/// volume; features.
Refusal may_collapse(const Mesh& mesh, Mesh::Halfedge_index h, const CollapseRules& rules);

/// Collapses the source of `h` onto its target. \pre may_collapse gave Refusal::none
/// \return the vertex that stays
Mesh::Vertex_index collapse(Mesh& mesh, Mesh::Halfedge_index h);

/// Whether moving vertex `v` to `to` sweeps a node of the shifted lattice: some tetrahedron
/// (v, to, a, b) over the triangles (v, a, b) of its star contains one.
bool sweeps_node(const Mesh& mesh, Mesh::Vertex_index v, const Point& to, const Lattice& lattice,
                 const Oracle& oracle);

/// Whether a node of the shifted lattice lies in the tetrahedron; false where it has no volume.
bool holds_node(const Point& a, const Point& b, const Point& c, const Point& d,
                const Lattice& lattice, const Oracle& oracle);

}  // namespace suture
