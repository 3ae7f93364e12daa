// Winding numbers of lattice nodes from signed crossings along lattice lines [§5.3's in/out
// counter].
#pragma once

#include <array>
#include <vector>

#include "kernel/sparse_field.h"
#include "surgery/detect/crossings.h"

namespace suture::surgery {

/// A lattice edge that the mesh crosses.
struct CrossedEdge {
  LatticeId edge;
  int before, after;           ///< windings of its lower and upper node
  std::uint32_t first, count;  ///< order(axis)[first .. first+count) index its line_crossings

  bool changes_side() const { return (before >= 1) != (after >= 1); }
  /// More than one crossing, or one that does not part inside from outside [§5.2].
  bool complex() const { return count > 1 || !changes_side(); }
};

/// Integer winding of every node of the lattice, stored as the crossed edges of each lattice line.
/// A node is inside the material where its winding is at least 1.
class Winding {
 public:
  /// \throw InternalFailure if a line does not end at winding 0 (the oracle lies)
  Winding(const Crossings& crossings);

  /// The winding of a node by the march along lattice lines of `axis`: the same on all three for a
  /// closed mesh.
  int at(const Index3& node, int axis = 2) const;
  bool inside(const Index3& node) const { return at(node) >= 1; }

  /// The edges along `axis` that the mesh crosses, line by line.
  const std::vector<CrossedEdge>& edges(int axis) const { return lines_[axis].edges; }
  const std::vector<std::uint32_t>& order(int axis) const { return lines_[axis].order; }

  /// The lattice edge along `axis` that leaves node `at`, or null where the mesh does not cross it.
  const CrossedEdge* edge(int axis, const Index3& at) const;

 private:
  struct Range {
    std::uint32_t begin = 0, end = 0;
  };
  struct Lines {
    std::vector<CrossedEdge> edges;
    std::vector<std::uint32_t> order;
    SparseField<Range> line;  // by the line's lowest edge
  };
  const CrossedEdge* last_up_to(int axis, const Index3& at) const;

  std::array<Lines, 3> lines_;
};

/// Whether the marches along x, y and z agree at both ends of every crossed lattice edge.
bool marches_agree(const Winding& winding);

}  // namespace suture::surgery
