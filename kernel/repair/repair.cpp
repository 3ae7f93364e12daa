// The steps of a repair; each leaves a surface that the next can take.
#include "kernel/repair/repair.h"

#include <algorithm>
#include <array>

#include "kernel/audit.h"
#include "kernel/corners.h"
#include "kernel/errors.h"
#include "kernel/repair/duplicates.h"
#include "kernel/repair/inside_out.h"
#include "kernel/repair/orientation.h"
#include "kernel/repair/weld.h"
#include "kernel/union_find.h"

namespace suture {

namespace {

std::size_t drop_degenerate(Triangles& surface) {
  return std::erase_if(surface.triangles,
                       [&](const Triangle& t) { return !usable(t, surface.positions.size()); });
}

// A border edge, by the first vertices at its two points, lower one first, and by its own vertices.
struct BorderEdge {
  std::array<std::uint32_t, 2> points, vertices;
};

std::vector<BorderEdge> border_edges(const Triangles& surface,
                                     const std::vector<std::uint32_t>& first) {
  const Corners corners(surface);
  std::vector<BorderEdge> result;
  for (const Triangle& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t a = t[k], b = t[(k + 1) % 3];
      int uses = 0;
      corners.for_each_use(a, b, [&](std::uint32_t, bool) { ++uses; });
      if (uses != 1 || first[a] == first[b]) continue;
      if (first[a] > first[b]) std::swap(a, b);
      result.push_back({{first[a], first[b]}, {a, b}});
    }
  std::stable_sort(result.begin(), result.end(),
                   [](const BorderEdge& a, const BorderEdge& b) { return a.points < b.points; });
  return result;
}

std::size_t weld_borders(Triangles& surface) {
  const std::vector<BorderEdge> edges = border_edges(surface, first_equal(surface.positions));
  UnionFind sets(surface.positions.size());
  std::size_t welded = 0;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].points == edges[i].points) ++end;
    if (end - i != 2) continue;
    for (std::size_t k = 0; k < 2; ++k)
      if (sets.join(edges[i].vertices[k], edges[i + 1].vertices[k])) ++welded;
  }
  for (Triangle& t : surface.triangles)
    for (std::uint32_t& v : t) v = sets.root(v);
  return welded;
}

// Welding can make triangles degenerate or repeated, and dropping those can leave two border edges
// where there were more, so the steps are repeated until nothing is left to do. Each round takes a
// triangle or a vertex away.
void drop_and_weld(Triangles& surface, RepairReport& report) {
  std::size_t done = 0;
  do {
    const std::size_t degenerate = drop_degenerate(surface);
    const DroppedCopies copies = drop_duplicates(surface);
    const std::size_t welded = weld_borders(surface);
    report.degenerate_triangles += degenerate;
    report.duplicate_triangles += copies.repeated;
    report.cancelled_triangles += copies.cancelled;
    report.welded_vertices += welded;
    done = degenerate + copies.repeated + copies.cancelled + welded;
  } while (done > 0);
}

// Gives each further fan of triangles round a vertex a vertex of its own.
std::size_t split_fans(Triangles& surface) {
  const Corners corners(surface);
  const std::size_t vertices = surface.positions.size();
  UnionFind sets(vertices);
  std::size_t added = 0;
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto v = static_cast<std::uint32_t>(i);
    const auto around = corners.of(v);
    for (const Corner& c : around) {
      sets.separate(c.next);
      sets.separate(c.prev);
    }
    for (const Corner& c : around) sets.join_to(c.next, c.prev);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> fans;  // root of a fan, its vertex
    for (const Corner& c : around) {
      const std::uint32_t fan = sets.root(c.next);
      auto found = std::find_if(fans.begin(), fans.end(), [&](auto& f) { return f.first == fan; });
      if (found == fans.end()) {
        const bool first = fans.empty();
        fans.emplace_back(fan, first ? v : static_cast<std::uint32_t>(surface.positions.size()));
        if (!first) {
          surface.positions.push_back(Point(surface.positions[v]));
          ++added;
        }
        found = fans.end() - 1;
      }
      for (std::uint32_t& corner : surface.triangles[c.triangle])
        if (corner == v) corner = found->second;
    }
  }
  return added;
}

std::size_t drop_unused(Triangles& surface) {
  std::vector<std::uint32_t> renamed(surface.positions.size(), kNone);
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t) renamed[v] = 0;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < renamed.size(); ++v)
    if (renamed[v] != kNone) {
      surface.positions[kept] = surface.positions[v];
      renamed[v] = static_cast<std::uint32_t>(kept++);
    }
  const std::size_t dropped = renamed.size() - kept;
  surface.positions.resize(kept);
  for (Triangle& t : surface.triangles)
    for (std::uint32_t& v : t) v = renamed[v];
  return dropped;
}

}  // namespace

bool RepairReport::changed() const { return !in_words().empty(); }

std::vector<std::string> RepairReport::in_words() const {
  struct Row {
    std::size_t count;
    const char *one, *many;
  };
  const Row rows[] = {
      {degenerate_triangles, "triangle that used a vertex twice was dropped",
       "triangles that used a vertex twice were dropped"},
      {duplicate_triangles, "repeated triangle was dropped", "repeated triangles were dropped"},
      {cancelled_triangles, "triangle was dropped with all its copies, as they enclosed nothing",
       "triangles were dropped with all their copies, as they enclosed nothing"},
      {welded_vertices, "vertex was welded to another at the same point",
       "vertices were welded to others at the same points"},
      {turned_triangles, "triangle was turned to agree with its neighbours",
       "triangles were turned to agree with their neighbours"},
      {split_vertices, "vertex was added to part surfaces that met in a point",
       "vertices were added to part surfaces that met in a point"},
      {inside_out_components, "inside-out component was turned over",
       "inside-out components were turned over"},
      {isolated_vertices, "vertex without triangles was dropped",
       "vertices without triangles were dropped"}};
  std::vector<std::string> words;
  for (const Row& r : rows)
    if (r.count > 0)
      words.push_back(std::to_string(r.count) + " " + (r.count == 1 ? r.one : r.many));
  return words;
}

RepairReport repair(Triangles& surface) {
  RepairReport report;
  const Audit before = audit(surface);
  if (!before.finite() || before.indices_out_of_range > 0) return report;
  drop_and_weld(surface, report);
  const std::size_t unused = audit(surface).isolated_vertices;
  report.turned_triangles = orient_consistently(surface).triangles;
  report.split_vertices = split_fans(surface);
  const std::vector<std::uint32_t> wrong = inside_out_components(surface);
  turn_components(surface, wrong);
  report.inside_out_components = wrong.size();
  drop_unused(surface);
  report.isolated_vertices = unused - report.welded_vertices;
  return report;
}

void require_usable(const Triangles& surface, const std::string& name) {
  require_closed_manifold(surface, name);
  const std::vector<std::uint32_t> wrong = inside_out_components(surface);
  if (wrong.empty()) return;
  throw InvalidInput(name + ": " + std::to_string(wrong.size()) +
                     (wrong.size() == 1 ? " component is" : " components are") +
                     " inside-out (negative volume), the first holds triangle " +
                     std::to_string(wrong[0]) + "; a repair turns such components over");
}

}  // namespace suture
