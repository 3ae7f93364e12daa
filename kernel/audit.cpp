// The audit: corners bucketed by vertex, so that every edge and every link is met once.
#include "kernel/audit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "kernel/corners.h"
#include "kernel/errors.h"
#include "kernel/union_find.h"

namespace suture {

namespace {

// What the walk round one vertex knows of a neighbour. `out` and `in` hold the vertex (plus one)
// that last had a triangle leave along, or arrive along, the edge to this neighbour: so nothing
// has to be cleared between vertices.
struct Neighbour {
  std::uint32_t out = 0, in = 0, after = 0;
};

// A place in words, made when a kind of fault is first met.
struct Places {
  std::string non_finite, range, degenerate, duplicate, border, edge, misoriented, vertex;
};

std::string name_triangle(std::size_t i, const Triangle& t) {
  return "triangle " + std::to_string(i) + " (" + std::to_string(t[0]) + ", " +
         std::to_string(t[1]) + ", " + std::to_string(t[2]) + ")";
}

std::string name_edge(std::uint32_t a, std::uint32_t b, std::uint32_t triangle) {
  return "edge (" + std::to_string(a) + ", " + std::to_string(b) + ") of triangle " +
         std::to_string(triangle);
}

// One use of the edge from a vertex to `other`: by a triangle that runs along it away from the
// vertex, or towards it.
struct EdgeUse {
  std::uint32_t other;
  bool outwards;
  std::uint32_t triangle;
};

class Auditor {
 public:
  explicit Auditor(const Triangles& surface) : surface_(surface), corners_(surface) {}

  Audit run() {
    check_positions();
    check_triangles();
    neighbours_.resize(surface_.positions.size());
    for (std::size_t v = 0; v < surface_.positions.size(); ++v)
      check_vertex(static_cast<std::uint32_t>(v));
    return std::move(audit_);
  }
  const Places& places() const { return places_; }

 private:
  static void count(std::size_t& counter, std::string& place, auto&& describe) {
    if (counter++ == 0) place = describe();
  }

  void check_positions() {
    for (std::size_t v = 0; v < surface_.positions.size(); ++v)
      if (!surface_.positions[v].allFinite())
        count(audit_.non_finite_vertices, places_.non_finite,
              [&] { return "vertex " + std::to_string(v); });
  }

  void check_triangles() {
    const std::size_t vertices = surface_.positions.size();
    used_.assign(vertices, 0);
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      const Triangle& t = surface_.triangles[i];
      for (const std::uint32_t v : t) {
        if (v < vertices)
          used_[v] = 1;
        else
          count(audit_.indices_out_of_range, places_.range, [&] { return name_triangle(i, t); });
      }
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        count(audit_.degenerate_triangles, places_.degenerate, [&] { return name_triangle(i, t); });
    }
    audit_.isolated_vertices =
        static_cast<std::size_t>(std::count(used_.begin(), used_.end(), std::uint8_t{0}));
  }

  // A regular vertex has each edge used once outwards and once inwards. Its link is then a set of
  // cycles, and one walk says whether it is a single cycle of three or more.
  void check_vertex(std::uint32_t v) {
    const auto around = corners_.of(v);
    if (around.empty()) return;
    const std::uint32_t stamp = v + 1;
    bool regular = true;
    for (const Corner& c : around) {
      Neighbour& out = neighbours_[c.next];
      Neighbour& in = neighbours_[c.prev];
      regular &= out.out != stamp && in.in != stamp;
      out.out = stamp;
      out.after = c.prev;
      in.in = stamp;
    }
    for (const Corner& c : around) regular &= neighbours_[c.next].in == stamp;
    if (regular) {
      std::size_t length = 0;
      std::uint32_t at = around[0].next;
      do at = neighbours_[at].after;
      while (++length < around.size() && at != around[0].next);
      if (length == around.size() && at == around[0].next && length > 2) return;
    }
    check_edges(v);
    check_duplicates(v);
    check_fans(v);
  }

  // Counts the faults of the edges to higher vertices, so that each edge is counted once.
  void check_edges(std::uint32_t v) {
    std::vector<EdgeUse> uses;
    for (const Corner& c : corners_.of(v)) {
      if (c.next > v) uses.push_back({c.next, true, c.triangle});
      if (c.prev > v) uses.push_back({c.prev, false, c.triangle});
    }
    std::stable_sort(uses.begin(), uses.end(),
                     [](const EdgeUse& a, const EdgeUse& b) { return a.other < b.other; });
    for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
      while (end < uses.size() && uses[end].other == uses[i].other) ++end;
      const auto place = [&] { return name_edge(v, uses[i].other, uses[i].triangle); };
      if (end - i == 1)
        count(audit_.border_edges, places_.border, place);
      else if (end - i > 2)
        count(audit_.non_manifold_edges, places_.edge, place);
      else if (uses[i].outwards == uses[i + 1].outwards)
        count(audit_.misoriented_edges, places_.misoriented, place);
    }
  }

  // Triangles of which v is the lowest vertex, compared by their other two.
  void check_duplicates(std::uint32_t v) {
    std::vector<std::array<std::uint32_t, 3>> others;
    for (const Corner& c : corners_.of(v))
      if (c.next > v && c.prev > v)
        others.push_back({std::min(c.next, c.prev), std::max(c.next, c.prev), c.triangle});
    std::sort(others.begin(), others.end());
    for (std::size_t i = 1; i < others.size(); ++i)
      if (others[i][0] == others[i - 1][0] && others[i][1] == others[i - 1][1])
        count(audit_.duplicate_triangles, places_.duplicate, [&] {
          const std::uint32_t t = others[i][2];
          return name_triangle(t, surface_.triangles[t]);
        });
  }

  // A vertex is non-manifold where its triangles, joined through shared edges, fall into parts.
  void check_fans(std::uint32_t v) {
    const auto around = corners_.of(v);
    if (!fans_) fans_.emplace(surface_.positions.size());
    for (const Corner& c : around) {
      fans_->separate(c.next);
      fans_->separate(c.prev);
    }
    for (const Corner& c : around) fans_->join_to(c.next, c.prev);
    const std::uint32_t whole = fans_->root(around[0].next);
    for (const Corner& c : around)
      if (fans_->root(c.next) != whole) {
        count(audit_.non_manifold_vertices, places_.vertex,
              [&] { return "vertex " + std::to_string(v); });
        return;
      }
  }

  const Triangles& surface_;
  Corners corners_;
  std::vector<Neighbour> neighbours_;
  std::optional<UnionFind> fans_;  // made for the first vertex that is not regular
  std::vector<std::uint8_t> used_;
  Audit audit_;
  Places places_;
};

std::vector<std::string> sentences(const Audit& a, const Places& p) {
  struct Row {
    std::size_t count;
    const char *one, *many;
    const std::string& place;
    const char* advice;
  };
  const Row rows[] = {
      {a.non_finite_vertices, "vertex has a coordinate that is not finite",
       "vertices have coordinates that are not finite", p.non_finite,
       "export the mesh again without NaN or infinity"},
      {a.indices_out_of_range, "vertex index is out of range", "vertex indices are out of range",
       p.range, "the mesh is incomplete; export it again"},
      {a.degenerate_triangles, "triangle uses a vertex twice", "triangles use a vertex twice",
       p.degenerate, "--repair drops such triangles"},
      {a.duplicate_triangles, "triangle repeats another", "triangles repeat others", p.duplicate,
       "--repair drops repeated triangles"},
      {a.border_edges, "border edge: the surface is open", "border edges: the surface is open",
       p.border,
       "fill the holes first; --repair welds equal points, which closes the mesh where its "
       "triangles merely do not share vertices"},
      {a.non_manifold_edges, "edge has three triangles or more",
       "edges have three triangles or more", p.edge, "separate the surfaces that meet there"},
      {a.misoriented_edges, "edge has two triangles that face opposite ways",
       "edges have two triangles that face opposite ways", p.misoriented,
       "--repair orients what can be oriented"},
      {a.non_manifold_vertices, "vertex joins more than one fan of triangles",
       "vertices join more than one fan of triangles", p.vertex, "--repair splits such vertices"}};
  std::vector<std::string> out;
  for (const Row& r : rows)
    if (r.count > 0)
      out.push_back(std::to_string(r.count) + " " + (r.count == 1 ? r.one : r.many) + ", first " +
                    r.place + " (" + r.advice + ")");
  return out;
}

}  // namespace

Audit audit(const Triangles& surface) {
  Auditor auditor(surface);
  Audit result = auditor.run();
  result.faults = sentences(result, auditor.places());
  if (!result.faults.empty()) result.first = result.faults.front();
  return result;
}

void require_closed_manifold(const Triangles& surface, const std::string& name) {
  if (surface.triangles.empty())
    throw InvalidInput(name + ": the mesh is empty; give a mesh with at least one triangle");
  const Audit result = audit(surface);
  if (result.closed_manifold()) return;
  std::string message = name + " is not a closed oriented manifold";
  for (std::size_t i = 0; i < result.faults.size(); ++i)
    message += (i == 0 ? ": " : "; ") + result.faults[i];
  throw InvalidInput(message);
}

}  // namespace suture
