// The signed distance field D at lattice nodes: exact, and computed only where it is asked for
// [§5.1].
#pragma once

#include <memory>
#include <vector>

#include "kernel/lattice.h"
#include "kernel/triangles.h"
#include "surgery/detect/winding.h"

namespace suture::surgery {

/// D at a node is the distance to the nearest triangle, negative where the winding is at least 1.
/// Values are kept once computed; the search tree is built at the first question. The arguments
/// must outlive the field.
class DistanceField {
 public:
  DistanceField(const Triangles& surface, const Lattice& lattice, const Winding& winding);
  ~DistanceField();
  DistanceField(DistanceField&&) noexcept;

  /// Has these triangles searched first (those that touch the cells round the nodes to be asked),
  /// and all others only where these cannot decide: the same values, found faster.
  void search_first(std::vector<std::uint32_t> near);

  /// D at a node of the lattice, in the scene's unit of length.
  double at(const Index3& node) const;
  std::size_t nodes_computed() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace suture::surgery
