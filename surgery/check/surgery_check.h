// A surface as detection sees it, for those who check the tracker from outside: windings at the
// lattice's nodes, by all three marches [§5.3].
#pragma once

#include <memory>
#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"
#include "surgery/model/options.h"

namespace suture {

/// The lattice on which a tracker with these options would remodel a surface with these vertices:
/// SurgeryReport::region and Index3 refer to it. \pre a position \throw InvalidInput as Tracker
Lattice lattice_of(const std::vector<Point>& positions, const TrackerOptions& options);

/// A surface seen from the nodes of a lattice, whatever remodel thinks of it.
class SurfaceCheck {
 public:
  /// Decides with `arithmetic`, which should be an exact one. \pre the surface is closed, finite,
  /// and the lattice holds it with a cell to spare; or it is empty
  /// \throw InternalFailure where a march does not close
  SurfaceCheck(const Triangles& surface, const Lattice& lattice,
               Arithmetic arithmetic = Arithmetic::filtered);
  ~SurfaceCheck();
  SurfaceCheck(SurfaceCheck&&) noexcept;

  /// Whether the marches along x, y and z give each node the same winding.
  bool marches_agree() const;

  /// Winding of a node by the march along `axis`; inside the material it is at least 1.
  int winding(const Index3& node, int axis = 2) const;

  /// The nodes whose side differs between two surfaces on the same lattice, in a defined order.
  static std::vector<Index3> sides_changed(const SurfaceCheck& a, const SurfaceCheck& b);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The number of detection's decisions that are ties, which the symbolic shift settles by the order
/// of the axes: vertices on planes, edges that meet lattice lines and triangles that meet nodes.
std::size_t count_ties(const Triangles& surface, const Lattice& lattice);

}  // namespace suture
