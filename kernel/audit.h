// Is it a closed, oriented, manifold, finite surface? Combinatorial and exact, no tolerance.
#pragma once

#include <string>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// Counts of everything that keeps a surface from being a closed oriented 2-manifold, with the
/// first place of each. An isolated vertex (in no triangle) is counted but is no reason to fail.
struct Audit {
  std::size_t non_finite_vertices = 0, indices_out_of_range = 0,
              degenerate_triangles = 0;   ///< degenerate: repeated index
  std::size_t duplicate_triangles = 0;    ///< same three vertices, any order
  std::size_t border_edges = 0;           ///< one triangle only
  std::size_t non_manifold_edges = 0;     ///< three triangles or more
  std::size_t misoriented_edges = 0;      ///< two triangles that run along it the same way
  std::size_t non_manifold_vertices = 0;  ///< whose triangles are more than one fan
  std::size_t isolated_vertices = 0;
  std::string first;                ///< the first fault, in words with its element's index
  std::vector<std::string> faults;  ///< one sentence a kind: count, first place, what to do

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

/// Linear in the size of the surface; safe on any input, whatever its indices and coordinates are.
Audit audit(const Triangles& surface);

/// \throw InvalidInput, naming every fault with its count and first place and what to do
/// (a repair where that can help), unless the surface is a closed oriented manifold with at least
/// one triangle
void require_closed_manifold(const Triangles& surface, const std::string& name);

}  // namespace suture
