// Collapses run along chains of arcs only; each chain is to become one edge [§6.1 step 3, §6.2].
#include "surgery/collapse/paper_order.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>

#include "kernel/errors.h"
#include "surgery/collapse/edge_collapse.h"
#include "surgery/collapse/queue.h"

namespace suture::surgery {

namespace {

using Vertex = Mesh::Vertex_index;

/// Neighbours along the chain of each type 2 vertex that is on the region's boundary.
class PaperOrder final : public CollapseOrder {
 public:
  PaperOrder(const Sewing& sewing, const CollapseRules& rules, const FaceMarks& doomed)
      : mesh_(sewing.mesh()), rules_(rules), doomed_(doomed) {
    before_.resize(mesh_.num_vertices(), Mesh::null_vertex());
    after_.resize(mesh_.num_vertices(), Mesh::null_vertex());
    is_type1_.resize(mesh_.num_vertices(), 0);
    for (const auto v : sewing.made().type1) is_type1_[v] = 1;
  }

  void follow(const std::vector<ArcChain>& chains, const Sewing& sewing) {
    for (const ArcChain& chain : chains)
      for (std::size_t i = 1; i + 1 < chain.sites.size(); ++i) {
        const Vertex v = sewing.vertex(chain.sites[i]);
        before_[v] = sewing.vertex(chain.sites[i - 1]);
        after_[v] = sewing.vertex(chain.sites[i + 1]);
      }
  }

  bool joins(Vertex from, Vertex to) const override {
    return before_[from] == to || after_[from] == to;
  }

  Refusal refusal(const Mesh& mesh, Mesh::Halfedge_index h) const override {
    if (premature(h)) return Refusal::premature;
    if (!keeps_manifold(mesh, h)) return Refusal::link;
    return judge(collapse_change(mesh, {h, to_point(mesh.point(mesh.target(h)))}, &doomed_),
                 rules_);
  }

  std::vector<VertexPair> collapsing(Vertex from, Vertex to) override {
    const bool forward = after_[from] == to;
    const Vertex other = forward ? before_[from] : after_[from];
    (forward ? before_ : after_)[to] = other;
    (forward ? after_ : before_)[other] = to;
    return {{other, to}, {to, other}};
  }

 private:
  /// Whether the collapse would join type 1 vertices that are not the two ends of its own arc.
  bool premature(Mesh::Halfedge_index h) const {
    const Vertex from = mesh_.source(h), to = mesh_.target(h);
    if (is_type1_[to] == 0) return false;
    const Vertex other = after_[from] == to ? before_[from] : after_[from];
    for (const auto g : mesh_.halfedges_around_target(mesh_.opposite(h))) {
      const Vertex n = mesh_.source(g);
      if (n == to || n == other || is_type1_[n] == 0) continue;
      if (!mesh_.halfedge(n, to).is_valid()) return true;
    }
    return false;
  }

  const Mesh& mesh_;
  const CollapseRules& rules_;
  const FaceMarks& doomed_;
  std::vector<Vertex> before_, after_;
  std::vector<char> is_type1_;
};

/// Removes the triangles that the cut touched, but for those that are in the region as they are,
/// and adds the parts on either side. \return marks of the faces in the region
FaceMarks subdivide(const CutMesh& cut, Sewing& sewing) {
  std::vector<std::uint32_t> replaced;
  std::set_difference(cut.touched.begin(), cut.touched.end(), cut.whole.begin(), cut.whole.end(),
                      std::back_inserter(replaced));
  sewing.remove(replaced);
  FaceMarks doomed = sewing.mesh().add_property_map<Mesh::Face_index, char>("f:doomed", 0).first;
  const std::vector<Mesh::Face_index> faces = sewing.add({&cut.kept, &cut.dropped});
  for (std::size_t i = cut.kept.size(); i < faces.size(); ++i) doomed[faces[i]] = 1;
  for (const std::uint32_t t : cut.whole) doomed[Mesh::Face_index(t)] = 1;
  return doomed;
}

void drop(Mesh& mesh, FaceMarks& doomed) {
  std::vector<Mesh::Face_index> faces;
  for (const auto f : mesh.faces())
    if (doomed[f] != 0) faces.push_back(f);
  for (const auto f : faces) CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
}

bool bent(const ArcChain& chain, const Sewing& sewing) {
  return std::any_of(chain.sites.begin() + 1, chain.sites.end() - 1,
                     [&](std::uint32_t s) { return !sewing.mesh().is_removed(sewing.vertex(s)); });
}

LatticeId across(const ArcChain& chain) {
  return step(chain.cell, chain.face / 2, chain.face % 2 == 1 ? 1 : -1);
}

}  // namespace

std::vector<ArcChain> chains_of(const std::vector<Arc>& boundary, const Sites& sites) {
  // A type 2 site is on one boundary face, which has one cell in the region: one arc leaves it.
  std::vector<std::uint32_t> onward(sites.all().size(), kNone);
  for (const Arc& arc : boundary)
    if (sites[arc.from].kind == SiteKind::type2) onward[arc.from] = arc.to;
  std::vector<ArcChain> chains;
  for (const Arc& arc : boundary) {
    if (sites[arc.from].kind != SiteKind::type1) continue;
    ArcChain chain{arc.cell, arc.face, {arc.from, arc.to}};
    while (sites[chain.sites.back()].kind == SiteKind::type2) {
      const std::uint32_t next = onward[chain.sites.back()];
      if (next == kNone || chain.sites.size() > onward.size())
        throw InternalFailure("collapse", "an arc does not lead to a type 1 vertex");
      chain.sites.push_back(next);
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

std::size_t bent_arcs(const std::vector<ArcChain>& chains, const Sewing& sewing) {
  return static_cast<std::size_t>(std::count_if(
      chains.begin(), chains.end(), [&](const ArcChain& c) { return bent(c, sewing); }));
}

OpenedMesh open_in_paper_order(const CutMesh& cut, Sewing& sewing, const CollapseRules& rules) {
  Mesh& mesh = sewing.mesh();
  FaceMarks doomed = subdivide(cut, sewing);
  const std::vector<ArcChain> chains = chains_of(cut.boundary, sewing.sites());
  PaperOrder order(sewing, rules, doomed);
  order.follow(chains, sewing);
  OpenedMesh result;
  result.collapses = collapse_type2(mesh, sewing.made(), order);
  for (const ArcChain& chain : chains) {
    if (bent(chain, sewing)) {
      ++result.bent_arcs;
      result.gridlocked.push_back(across(chain));
    } else {
      result.boundary.push_back({chain.cell, chain.face, chain.sites.front(), chain.sites.back()});
    }
  }
  std::sort(result.gridlocked.begin(), result.gridlocked.end());
  if (!result.gridlocked.empty()) result.boundary.clear();
  drop(mesh, doomed);
  mesh.remove_property_map(doomed);
  return result;
}

}  // namespace suture::surgery
