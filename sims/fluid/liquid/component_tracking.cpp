// Which bodies of liquid after a remodel are which before it, whatever merged and split.
#include "sims/fluid/liquid/component_tracking.h"

#include <algorithm>
#include <map>
#include <optional>

#include "kernel/lattice.h"
#include "kernel/repair/weld.h"
#include "kernel/union_find.h"

namespace suture::sims {
namespace {

constexpr std::size_t kSample = 64;  // vertices; in eighths of them a body is told by its share
constexpr std::size_t kShare = 8;

struct Side {
  const Triangles& surface;
  const LiquidBodies& bodies;
  std::vector<std::uint32_t> of_vertex;
  std::vector<std::uint8_t> linked;
  std::optional<NearestTriangle> nearest;

  Side(const Triangles& s, const LiquidBodies& b)
      : surface(s), bodies(b), of_vertex(s.positions.size(), kNone), linked(b.count, 0) {
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
      for (const std::uint32_t v : s.triangles[t]) of_vertex[v] = b.of_triangle[t];
  }
};

void join_by_vertices(Side& before, Side& after, UnionFind& sets) {
  std::vector<Point> all = before.surface.positions;
  all.insert(all.end(), after.surface.positions.begin(), after.surface.positions.end());
  const std::vector<std::uint32_t> first = first_equal(all);
  const std::size_t split = before.surface.positions.size();
  for (std::size_t v = 0; v < after.of_vertex.size(); ++v) {
    const std::uint32_t same = first[split + v];
    if (same >= split || after.of_vertex[v] == kNone || before.of_vertex[same] == kNone) continue;
    before.linked[before.of_vertex[same]] = after.linked[after.of_vertex[v]] = 1;
    sets.join(before.of_vertex[same],
              static_cast<std::uint32_t>(before.bodies.count) + after.of_vertex[v]);
  }
}

/// The bodies of `other` that the body is near to. \pre other has a triangle
std::vector<std::uint32_t> near_to(const std::vector<std::uint32_t>& vertices, const Side& own,
                                   Side& other) {
  if (!other.nearest) other.nearest.emplace(other.surface);
  std::vector<Point> sample;
  const std::size_t count = std::min(kSample, vertices.size());
  for (std::size_t i = 0; i < count; ++i)
    sample.push_back(own.surface.positions[vertices[i * vertices.size() / count]]);
  const Box box = bounding_box(sample);
  const double width = (box.high - box.low).norm();
  std::map<std::uint32_t, std::size_t> votes;
  for (const Point& p : sample)
    if (other.nearest->distance(p) <= width)
      ++votes[other.bodies.of_triangle[other.nearest->triangle(p)]];
  std::vector<std::uint32_t> near;
  for (const auto& [body, n] : votes)
    if (kShare * n >= count) near.push_back(body);
  return near;
}

void join_by_nearness(Side& own, Side& other, bool own_is_before, UnionFind& sets) {
  if (other.surface.triangles.empty()) return;
  std::vector<std::vector<std::uint32_t>> vertices(own.bodies.count);
  for (std::uint32_t v = 0; v < own.of_vertex.size(); ++v)
    if (const std::uint32_t body = own.of_vertex[v]; body != kNone && own.linked[body] == 0)
      vertices[body].push_back(v);
  const auto own_first = static_cast<std::uint32_t>(own_is_before ? 0 : other.bodies.count);
  const auto other_first = static_cast<std::uint32_t>(own_is_before ? own.bodies.count : 0);
  for (std::uint32_t body = 0; body < own.bodies.count; ++body)
    if (!vertices[body].empty())
      for (const std::uint32_t near : near_to(vertices[body], own, other))
        sets.join(own_first + body, other_first + near);
}

}  // namespace

BodyGroups body_groups(const Triangles& before, const LiquidBodies& bodies_before,
                       const Triangles& after, const LiquidBodies& bodies_after) {
  Side first(before, bodies_before), second(after, bodies_after);
  UnionFind sets(bodies_before.count + bodies_after.count);
  join_by_vertices(first, second, sets);
  join_by_nearness(first, second, true, sets);
  join_by_nearness(second, first, false, sets);
  BodyGroups groups;
  std::vector<std::uint32_t> number(bodies_before.count + bodies_after.count, kNone);
  for (std::uint32_t body = 0; body < number.size(); ++body) {
    std::uint32_t& n = number[sets.root(body)];
    if (n == kNone) n = static_cast<std::uint32_t>(groups.count++);
    (body < bodies_before.count ? groups.before : groups.after).push_back(n);
  }
  return groups;
}

}  // namespace suture::sims
