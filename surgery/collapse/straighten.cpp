// Every neighbour of either type will do, and the surface is closed: only the rules can refuse.
#include "surgery/collapse/straighten.h"

#include "surgery/collapse/edge_collapse.h"
#include "surgery/collapse/queue.h"

namespace suture::surgery {

namespace {

class ClosedSurfaceOrder final : public CollapseOrder {
 public:
  explicit ClosedSurfaceOrder(const CollapseRules& rules) : rules_(rules) {}
  bool joins(Mesh::Vertex_index, Mesh::Vertex_index) const override { return true; }
  Refusal refusal(const Mesh& mesh, Mesh::Halfedge_index h) const override {
    return may_collapse(mesh, h, rules_);
  }
  std::vector<VertexPair> collapsing(Mesh::Vertex_index, Mesh::Vertex_index) override { return {}; }

 private:
  const CollapseRules& rules_;
};

}  // namespace

CollapseCounts straighten(Mesh& mesh, const StitchedVertices& vertices,
                          const CollapseRules& rules) {
  ClosedSurfaceOrder order(rules);
  return collapse_type2(mesh, vertices, order);
}

}  // namespace suture::surgery
