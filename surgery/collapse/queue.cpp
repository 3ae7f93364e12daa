// One sorted list holds the edges known at the start, one heap those that come later.
#include "surgery/collapse/queue.h"

#include <algorithm>
#include <queue>
#include <tuple>

#include "surgery/collapse/edge_collapse.h"

namespace suture::surgery {

namespace {

enum class Role : std::uint8_t { other, type1, type2 };

/// An edge from a type 2 vertex to one that it may become; type 1 before type 2, then the shortest.
struct Candidate {
  Role role;
  double length;  ///< squared
  Mesh::Vertex_index from, to;

  bool operator>(const Candidate& b) const {
    return std::tie(role, length, from, to) > std::tie(b.role, b.length, b.from, b.to);
  }
};

class CollapseQueue {
 public:
  CollapseQueue(Mesh& mesh, const StitchedVertices& vertices, CollapseOrder& order)
      : mesh_(mesh), order_(order) {
    role_.resize(mesh.num_vertices(), Role::other);
    refusal_.resize(mesh.num_vertices(), Refusal::none);
    for (const auto v : vertices.type2) role_[v] = Role::type2;
    for (const auto v : vertices.type1) role_[v] = Role::type1;
    for (const auto v : vertices.type2)
      if (role_[v] == Role::type2)
        for (const auto h : mesh_.halfedges_around_target(mesh_.halfedge(v)))
          if (allowed(v, mesh_.source(h))) first_.push_back(candidate(v, mesh_.source(h)));
    std::sort(first_.begin(), first_.end(),
              [](const Candidate& a, const Candidate& b) { return b > a; });
  }

  void collapse_all(CollapseCounts& counts) {
    while (at_ < first_.size() || !queue_.empty()) {
      const Candidate next = take();
      if (mesh_.is_removed(next.from) || mesh_.is_removed(next.to)) continue;
      const auto h = mesh_.halfedge(next.from, next.to);
      if (!h.is_valid()) continue;
      if (!order_.joins(next.from, next.to)) continue;
      const Refusal refusal = order_.refusal(mesh_, h);
      refusal_[next.from] = refusal;
      if (refusal != Refusal::none) {
        ++counts.blocked;
        continue;
      }
      const std::vector<Mesh::Vertex_index> gained = neighbours_gained(h);
      const std::vector<VertexPair> known = order_.collapsing(next.from, next.to);
      const auto stays = collapse(mesh_, h);
      ++counts.done;
      for (const auto n : gained) {
        push(n, stays);
        push(stays, n);
      }
      for (const auto& [a, b] : known) push(a, b);
      retry_refused_around(stays);
    }
  }

  Refusal last_refusal(Mesh::Vertex_index v) const { return refusal_[v]; }

 private:
  bool allowed(Mesh::Vertex_index from, Mesh::Vertex_index to) const {
    return role_[from] == Role::type2 && role_[to] != Role::other && order_.joins(from, to);
  }

  void push(Mesh::Vertex_index from, Mesh::Vertex_index to) {
    if (allowed(from, to)) queue_.push(candidate(from, to));
  }

  Candidate candidate(Mesh::Vertex_index from, Mesh::Vertex_index to) const {
    return {role_[to], CGAL::squared_distance(mesh_.point(from), mesh_.point(to)), from, to};
  }

  /// The best candidate: from those known at the start, sorted once, or from those that came later.
  Candidate take() {
    if (queue_.empty() || (at_ < first_.size() && queue_.top() > first_[at_])) return first_[at_++];
    const Candidate next = queue_.top();
    queue_.pop();
    return next;
  }

  void push_all(Mesh::Vertex_index v) {
    for (const auto h : mesh_.halfedges_around_target(mesh_.halfedge(v))) push(v, mesh_.source(h));
  }

  /// The vertices that only the source of h is joined to now, and its target will be. Other edges
  /// stay in the queue: no vertex moves, so their lengths do not change.
  std::vector<Mesh::Vertex_index> neighbours_gained(Mesh::Halfedge_index h) const {
    std::vector<Mesh::Vertex_index> gained;
    for (const auto r : mesh_.halfedges_around_target(mesh_.opposite(h))) {
      const auto n = mesh_.source(r);
      if (n != mesh_.target(h) && !mesh_.halfedge(n, mesh_.target(h)).is_valid())
        gained.push_back(n);
    }
    return gained;
  }

  /// A collapse changes the stars of the vertex that stays and of all its neighbours.
  void retry_refused_around(Mesh::Vertex_index v) {
    retry_if_refused(v);
    for (const auto h : mesh_.halfedges_around_target(mesh_.halfedge(v)))
      retry_if_refused(mesh_.source(h));
  }
  void retry_if_refused(Mesh::Vertex_index v) {
    if (refusal_[v] == Refusal::none) return;
    refusal_[v] = Refusal::none;
    push_all(v);
  }

  Mesh& mesh_;
  CollapseOrder& order_;
  std::vector<Role> role_;
  std::vector<Refusal> refusal_;
  std::vector<Candidate> first_;
  std::size_t at_ = 0;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

CollapseCounts collapse_type2(Mesh& mesh, const StitchedVertices& vertices, CollapseOrder& order) {
  CollapseCounts counts;
  CollapseQueue work(mesh, vertices, order);
  work.collapse_all(counts);
  for (const auto v : vertices.type2)
    if (!mesh.is_removed(v)) {
      const Refusal refusal = work.last_refusal(v);
      if (refusal == Refusal::none) ++counts.delayed;
      count_refusal(counts, refusal);
    }
  return counts;
}

}  // namespace suture::surgery
