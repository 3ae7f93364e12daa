// Mending what has exactly one right answer, and refusing what the tracker cannot use.
#pragma once

#include <string>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// What `repair` did, as counts.
struct RepairReport {
  std::size_t degenerate_triangles = 0;   ///< dropped: a vertex used twice
  std::size_t duplicate_triangles = 0;    ///< dropped: the same three vertices as another
  std::size_t welded_vertices = 0;        ///< gone into another at exactly the same point
  std::size_t turned_triangles = 0;       ///< turned over to agree with their neighbours
  std::size_t split_vertices = 0;         ///< vertices added where fans met in one point only
  std::size_t inside_out_components = 0;  ///< turned over whole
  std::size_t isolated_vertices = 0;      ///< dropped: in no triangle

  bool changed() const;
  /// One sentence for each thing done; empty where nothing was.
  std::vector<std::string> in_words() const;
};

/// Mends in place, in this order. Degenerate triangles go. Of triangles on the same three vertices
/// one stays if an odd number of other triangles ends at their edges, else none: so a body whose
/// triangles are all given twice goes as a whole, a known fault. Points are welded
/// along pairs of border edges that coincide exactly, never elsewhere: closed surfaces that touch
/// stay apart, and no third triangle is put on an edge. Then `orient_consistently`, a vertex for
/// each fan, `inside_out_components` turned, isolated vertices dropped. What is left (open, three
/// triangles on an edge) `audit` reports. A surface with coordinates that are not finite or indices
/// out of range is left alone. Twice does what once does.
RepairReport repair(Triangles& surface);

/// \throw InvalidInput unless the surface is a closed manifold (`require_closed_manifold`) and no
/// component is inside-out; the message says how many are, where the first is, and what to do
void require_usable(const Triangles& surface, const std::string& name);

}  // namespace suture
