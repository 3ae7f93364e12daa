// Mending faults that have just one right answer, and refusing surfaces that the tracker cannot
// use.
#pragma once

#include <string>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// Counts of the changes that `repair` made.
struct RepairReport {
  std::size_t degenerate_triangles = 0;   ///< were dropped, as one vertex stood at two corners
  std::size_t duplicate_triangles = 0;    ///< were dropped, and one on the same vertices stayed
  std::size_t cancelled_triangles = 0;    ///< were dropped with all others on the same vertices
  std::size_t welded_vertices = 0;        ///< became one with another at exactly the same point
  std::size_t turned_triangles = 0;       ///< were turned over to agree with their neighbours
  std::size_t split_vertices = 0;         ///< were added where fans met in one point only
  std::size_t inside_out_components = 0;  ///< were turned over whole
  std::size_t isolated_vertices = 0;      ///< were dropped, as they were in no triangle

  bool changed() const;
  /// A sentence for each kind of change; empty where nothing was changed.
  std::vector<std::string> in_words() const;
};

/// Mends in place, in this order. Degenerate triangles go. Of triangles on the same three vertices
/// one stays, but none of a wall inside a body or of a cover from both sides (`drop_duplicates`).
/// Points are welded along pairs of border edges that coincide exactly, and only there: closed
/// surfaces that touch stay apart, and no edge gets a third triangle. Triangles are oriented, each
/// fan gets a vertex of its own, inside-out components are turned, and isolated vertices go.
/// `audit` reports what is left. A surface with coordinates that are not finite or indices out of
/// range is left alone. A second repair finds nothing to do.
RepairReport repair(Triangles& surface);

/// Refuses all but closed manifolds (`require_closed_manifold`) without an inside-out component.
/// \throw InvalidInput that says how many components are inside-out, where the first is, and what
/// to do
void require_usable(const Triangles& surface, const std::string& name);

}  // namespace suture
