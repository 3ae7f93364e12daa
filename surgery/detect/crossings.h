// Mesh ∩ lattice: one table that every later stage reads [§5, §6.1 steps 1 and 2].
#pragma once

#include <array>
#include <vector>

#include "kernel/incidence.h"
#include "surgery/detect/lattice_path.h"

namespace suture::surgery {

/// \throw InvalidInput if the crossings would outnumber 32-bit indices or not fit this machine's
/// memory, with both numbers and what to do. The estimate is linear and allocates nothing.
void require_crossings_fit(const Triangles& surface, const Lattice& lattice);

/// Triangle × lattice line: a type 1 vertex where its lattice edge is on the region's boundary.
struct LineCrossing {
  LatticeId edge;
  std::uint32_t triangle;
  std::int8_t axis;   ///< of the lattice edge
  std::int8_t delta;  ///< by how much the winding changes along +axis: −(sign of the normal)
};

/// All crossings, in the order of the mesh's edges and triangles.
struct Crossings {
  std::vector<Index3> vertex_cell;
  std::vector<std::uint32_t> edge_begin;  ///< edge e's crossings: [edge_begin[e], edge_begin[e+1])
  std::vector<FaceStep> edge_crossings;   ///< mesh edge × plane, from the lower-indexed end on
  std::vector<std::uint32_t> triangle_begin;         ///< likewise for line_crossings
  std::vector<LineCrossing> line_crossings;          ///< each once
  std::array<std::vector<LatticeId>, 3> loop_faces;  ///< by axis: faces that hold a closed loop

  std::size_t size() const { return edge_crossings.size() + line_crossings.size(); }
};

/// The lattice lines that are scanned: all, or those along z, which are enough for windings.
enum class Lines { all, along_z };

/// \pre the lattice holds every vertex with a cell to spare; positions finite
/// \throw InternalFailure where the oracle contradicts itself
Crossings find_crossings(const Incidence& mesh, const ShiftedLattice& on, Lines lines = Lines::all);

/// A mesh with its crossings. All must outlive it.
struct CrossedMesh {
  const Incidence& mesh;
  ShiftedLattice on;
  const Crossings& crossings;
};

/// The two edge crossings at which the boundary of a triangle passes a plane.
struct PlaneEnds {
  std::uint32_t up = kNone, down = kNone;  ///< indices of edge_crossings
};

/// The planes across one axis that a triangle passes: plane first + i has ends[i].
struct TrianglePlanes {
  int first = 0;
  std::vector<PlaneEnds> ends;

  /// Puts the planes across `axis` that `triangle` passes in place of those before.
  /// \throw InternalFailure unless each plane between its vertices is passed once up and once down
  void find(const CrossedMesh& in, std::uint32_t triangle, int axis);
};

/// Calls visit(cell) with every cell that the triangle touches, some of them more than once.
template <class Visit>
void for_each_cell(const CrossedMesh& in, std::uint32_t triangle, Visit visit) {
  const Incidence& mesh = in.mesh;
  const Crossings& crossings = in.crossings;
  const Triangle& v = mesh.triangles[triangle];
  visit(pack(crossings.vertex_cell[v[0]]));
  if (crossings.vertex_cell[v[1]] == crossings.vertex_cell[v[0]] &&
      crossings.vertex_cell[v[2]] == crossings.vertex_cell[v[0]])
    return;  // most triangles of a fine mesh
  visit(pack(crossings.vertex_cell[v[1]]));
  visit(pack(crossings.vertex_cell[v[2]]));
  for (const std::uint32_t e : mesh.triangle_edges[triangle])
    for (std::uint32_t c = crossings.edge_begin[e]; c < crossings.edge_begin[e + 1]; ++c) {
      const FaceStep& face = crossings.edge_crossings[c];
      visit(face.face);
      visit(step(face.face, face.axis, -1));
    }
  for (std::uint32_t c = crossings.triangle_begin[triangle];
       c < crossings.triangle_begin[triangle + 1]; ++c)
    cells_round_edge(crossings.line_crossings[c].edge, crossings.line_crossings[c].axis, visit);
}

}  // namespace suture::surgery
