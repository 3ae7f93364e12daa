// Type 2 vertices are collapsed after the surface is closed, shortest edge first [§6.1 step 3].
#include "surgery/straighten.h"

#include <queue>
#include <tuple>

#include "surgery/local_change.h"

namespace suture {

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

class Straightening {
 public:
  Straightening(Mesh& mesh, const std::vector<Mesh::Vertex_index>& type2,
                const std::vector<Mesh::Vertex_index>& type1, const CollapseRules& rules)
      : mesh_(mesh), rules_(rules) {
    role_.resize(mesh.num_vertices(), Role::other);
    refusal_.resize(mesh.num_vertices(), Refusal::none);
    for (const auto v : type2) role_[v] = Role::type2;
    for (const auto v : type1) role_[v] = Role::type1;
    for (const auto v : type2)
      if (role_[v] == Role::type2) push(v);
  }

  void run(CollapseCounts& counts) {
    while (!queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if (mesh_.is_removed(next.from) || mesh_.is_removed(next.to)) continue;
      const auto h = mesh_.halfedge(next.from, next.to);
      if (!h.is_valid()) continue;
      const Refusal refusal = may_collapse(mesh_, h, rules_);
      refusal_[next.from] = refusal;
      if (refusal != Refusal::none) continue;
      const auto stays = collapse(mesh_, h);
      ++counts.done;
      try_again_around(stays);
    }
  }

  Refusal last_refusal(Mesh::Vertex_index v) const { return refusal_[v]; }

 private:
  void push(Mesh::Vertex_index v) {
    const auto first = mesh_.halfedge(v);
    for (const auto h : mesh_.halfedges_around_target(first)) {
      const auto to = mesh_.source(h);
      if (role_[to] != Role::other)
        queue_.push({role_[to], CGAL::squared_distance(mesh_.point(v), mesh_.point(to)), v, to});
    }
  }

  /// A collapse changes the stars of the vertex that stays and of all its neighbours.
  void try_again_around(Mesh::Vertex_index v) {
    if (role_[v] == Role::type2) push(v);
    for (const auto h : mesh_.halfedges_around_target(mesh_.halfedge(v)))
      if (role_[mesh_.source(h)] == Role::type2) push(mesh_.source(h));
  }

  Mesh& mesh_;
  const CollapseRules& rules_;
  std::vector<Role> role_;
  std::vector<Refusal> refusal_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

CollapseCounts straighten(Mesh& mesh, const std::vector<Mesh::Vertex_index>& type2,
                          const std::vector<Mesh::Vertex_index>& type1,
                          const CollapseRules& rules) {
  CollapseCounts counts;
  Straightening work(mesh, type2, type1, rules);
  work.run(counts);
  for (const auto v : type2)
    if (!mesh.is_removed(v)) {
      const Refusal refusal = work.last_refusal(v);
      if (refusal == Refusal::none) ++counts.delayed;
      count_refusal(counts, refusal);
    }
  return counts;
}

}  // namespace suture
