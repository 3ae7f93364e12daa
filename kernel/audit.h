// Whether a surface is closed, oriented, manifold and finite: combinatorial, with no tolerance.
#pragma once

#include <string>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// Counts of everything that keeps a surface from being a closed oriented 2-manifold, and the first
/// place of each. An isolated vertex, which is in no triangle, is counted but is no reason to fail.
struct Audit {
  std::size_t non_finite_vertices = 0;
  std::size_t indices_out_of_range = 0;
  std::size_t degenerate_triangles = 0;   ///< one vertex stands at two corners
  std::size_t duplicate_triangles = 0;    ///< another has the same three vertices, in any order
  std::size_t border_edges = 0;           ///< only one triangle is at the edge
  std::size_t non_manifold_edges = 0;     ///< three triangles or more are at the edge
  std::size_t misoriented_edges = 0;      ///< both triangles run along the edge the same way
  std::size_t non_manifold_vertices = 0;  ///< the triangles round the vertex are several fans
  std::size_t isolated_vertices = 0;
  std::string first;                ///< the first sentence of `faults`
  std::vector<std::string> faults;  ///< a sentence for each kind: count, first place, what to do

  bool closed() const { return border_edges == 0; }
  bool oriented() const { return misoriented_edges == 0; }
  bool edge_manifold() const { return non_manifold_edges == 0 && duplicate_triangles == 0; }
  bool vertex_manifold() const { return non_manifold_vertices == 0; }
  bool finite() const { return non_finite_vertices == 0; }
  bool closed_manifold() const {
    return closed() && oriented() && edge_manifold() && vertex_manifold() && finite() &&
           indices_out_of_range == 0 && degenerate_triangles == 0;
  }
};

/// Audits the surface, whatever its indices and coordinates are. It takes linear time.
Audit audit(const Triangles& surface);

/// Refuses all but closed oriented manifolds with at least one triangle. `name` stands for the
/// surface in the message.
/// \throw InvalidInput with the count and first place of every fault, and what to do: for some that
/// is a repair (`repair`)
void require_closed_manifold(const Triangles& surface, const std::string& name);

}  // namespace suture
