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

constexpr std::size_t kSample = 64;  // vertices that a body is asked by
constexpr std::size_t kPart = 8;     // an eighth of them has to be near another body

/// One of the two surfaces, whose bodies have the numbers from `first` on among those of both.
struct Side {
  const Triangles& surface;
  const LiquidBodies& bodies;
  std::uint32_t first;
  std::vector<std::uint32_t> of_vertex;
  std::vector<std::uint8_t> linked;
  std::optional<NearestTriangle> nearest;

  Side(const SurfaceBodies& side, std::size_t first_number)
      : surface(side.surface),
        bodies(side.bodies),
        first(static_cast<std::uint32_t>(first_number)),
        of_vertex(surface.positions.size(), kNone),
        linked(bodies.count, 0) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      for (const std::uint32_t v : surface.triangles[t]) of_vertex[v] = bodies.of_triangle[t];
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
    sets.join(before.first + before.of_vertex[same], after.first + after.of_vertex[v]);
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
    if (kPart * n >= count) near.push_back(body);
  return near;
}

void join_by_nearness(const Side& own, Side& other, UnionFind& sets) {
  if (other.surface.triangles.empty()) return;
  std::vector<std::vector<std::uint32_t>> vertices(own.bodies.count);
  for (std::uint32_t v = 0; v < own.of_vertex.size(); ++v)
    if (const std::uint32_t body = own.of_vertex[v]; body != kNone && own.linked[body] == 0)
      vertices[body].push_back(v);
  for (std::uint32_t body = 0; body < own.bodies.count; ++body)
    if (!vertices[body].empty())
      for (const std::uint32_t near : near_to(vertices[body], own, other))
        sets.join(own.first + body, other.first + near);
}

}  // namespace

ComponentGroups track_components(const SurfaceBodies& before, const SurfaceBodies& after) {
  const std::size_t split = before.bodies.count, all = split + after.bodies.count;
  Side first(before, 0), second(after, split);
  UnionFind sets(all);
  join_by_vertices(first, second, sets);
  join_by_nearness(first, second, sets);
  join_by_nearness(second, first, sets);
  ComponentGroups groups;
  std::vector<std::uint32_t> number(all, kNone);
  for (std::uint32_t body = 0; body < all; ++body) {
    std::uint32_t& n = number[sets.root(body)];
    if (n == kNone) n = static_cast<std::uint32_t>(groups.count++);
    (body < split ? groups.before : groups.after).push_back(n);
  }
  return groups;
}

}  // namespace suture::sims
