// Type 2 vertices collapse shortest edge first, again when a star nearby has changed [§6.1 step 3].
#pragma once

#include <utility>
#include <vector>

#include "surgery/collapse/rules.h"
#include "surgery/operate/stitch.h"

namespace suture::surgery {

/// A collapse of the first vertex onto the second, which stays.
using VertexPair = std::pair<Mesh::Vertex_index, Mesh::Vertex_index>;

/// One order of collapses: its own choices.
class CollapseOrder {
 public:
  virtual ~CollapseOrder() = default;
  /// Whether the type 2 vertex `from` may ever become its neighbour `to`.
  virtual bool joins(Mesh::Vertex_index from, Mesh::Vertex_index to) const = 0;
  /// The rule against collapsing the source of `h` onto its target now.
  virtual Refusal refusal(const Mesh& mesh, Mesh::Halfedge_index h) const = 0;
  /// Hears of each collapse before it happens. \return pairs that may now be tried although both
  /// knew each other
  virtual std::vector<VertexPair> collapsing(Mesh::Vertex_index from, Mesh::Vertex_index to) = 0;
};

/// Collapses each type 2 vertex onto a neighbour that is type 1 or, failing that, type 2; shortest
/// edge first, and tried again whenever a collapse nearby has changed its star. A vertex that no
/// rule allows to go stays and is counted once, under the rule that refused it last; as `delayed`
/// where it has no neighbour of either type. Deterministic; garbage is left in place.
CollapseCounts collapse_type2(Mesh& mesh, const StitchedVertices& vertices, CollapseOrder& order);

}  // namespace suture::surgery
