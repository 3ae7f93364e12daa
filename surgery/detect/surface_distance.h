// The signed distance field of a tracked surface, for whoever asks: a simulator, a picture [§5.1].
#pragma once

#include <memory>
#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"
#include "surgery/model/options.h"

namespace suture {

/// D on the lattice of a tracker: at a node, the exact distance to the nearest triangle, negative
/// where the node's winding is at least 1. Detection runs once; each distance is computed when it
/// is asked for.
class SurfaceDistance {
 public:
  /// Takes a copy of what it needs. \pre `surface` is a closed manifold and not empty
  SurfaceDistance(const Triangles& surface, const TrackerOptions& options);
  ~SurfaceDistance();
  SurfaceDistance(SurfaceDistance&&) noexcept;

  const Lattice& lattice() const;
  /// The corners of all cells that hold mesh, each once, in a defined order: where D is local.
  const std::vector<Index3>& surface_nodes() const;
  /// D at any node of the lattice, in the scene's unit of length.
  double at(const Index3& node) const;
  /// The number of distances computed so far.
  std::size_t computed() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace suture
