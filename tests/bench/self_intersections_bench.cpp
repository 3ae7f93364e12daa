// Pairs of triangles that pass through one another, before and after one remodel, by their causes:
// a CSV row a case on standard output.
#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "kernel/random.h"
#include "kernel/self_intersections.h"
#include "sims/option_names.h"
#include "surgery/tracker_lattice.h"
#include "tests/models.h"
#include "tests/surgery/hostile.h"
#include "tests/surgery/support.h"

using namespace suture;

namespace {

constexpr std::size_t kMostPairs = 2'000'000;

struct Case {
  std::string name;
  std::vector<HostileCase> inputs;
};

/// What the pairs after a remodel are made of.
struct Counts {
  std::size_t operated = 0, refused = 0, before = 0, after = 0;
  std::size_t old_old = 0;    ///< two triangles of the input that surgery left as they were
  std::size_t old_new = 0;    ///< one of them, and one that surgery made or changed
  std::size_t same_cell = 0;  ///< two new ones whose centres are in one cell
  std::size_t apart = 0;      ///< two new ones whose centres are in different cells
  std::size_t triangles = 0, without_area = 0;
};

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// For each triangle of `after`, whether it is one of `before`.
std::vector<char> old_ones(const Triangles& before, const Triangles& after,
                           const std::vector<std::uint32_t>& map) {
  std::set<Triangle> images;
  for (const Triangle& t : before.triangles)
    images.insert(sorted({map[t[0]], map[t[1]], map[t[2]]}));
  std::vector<char> old;
  for (const Triangle& t : after.triangles) old.push_back(images.contains(sorted(t)) ? 1 : 0);
  return old;
}

void count(const HostileCase& input, Collapse collapse, Counts& c) {
  TrackerOptions options = input.options;
  options.collapse = collapse;
  Tracker tracker(input.surface, options);
  const SurgeryReport report = tracker.remodel();
  c.refused += report.outcome == Outcome::refused ? 1 : 0;
  if (report.outcome != Outcome::committed) return;
  ++c.operated;
  const Triangles& after = tracker.surface();
  const SelfIntersections found = self_intersections(after, {kMostPairs});
  c.before += self_intersections(input.surface, {kMostPairs}).pairs.size();
  c.after += found.pairs.size();
  c.triangles += after.triangles.size();
  c.without_area += found.without_area;
  if (found.pairs.empty()) return;
  const std::vector<char> old = old_ones(input.surface, after, report.vertex_map);
  const Lattice lattice = tracker_lattice(input.surface.positions, options);
  const auto cell = [&](std::uint32_t t) {
    const Triangle& v = after.triangles[t];
    const auto& p = after.positions;
    return lattice.cell_of(Point(p[v[0]] / 3 + p[v[1]] / 3 + p[v[2]] / 3));
  };
  for (const auto& [a, b] : found.pairs) {
    std::size_t& kind = old[a] && old[b]     ? c.old_old
                        : old[a] || old[b]   ? c.old_new
                        : cell(a) == cell(b) ? c.same_cell
                                             : c.apart;
    ++kind;
  }
}

Triangles tangle(std::uint64_t seed, int frequency, double reach) {
  Random random(seed);
  Triangles body = ball(1, Point::Zero(), frequency);
  for (Point& p : body.positions)
    p += reach * Point(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return body;
}

TrackerOptions cells(const Triangles& surface, int n) {
  const Box box = bounding_box(surface.positions);
  TrackerOptions options;
  options.cell_size = (box.high - box.low).maxCoeff() / n;
  return options;
}

Case one(std::string name, const Triangles& surface, int n) {
  return {std::move(name), {{surface, cells(surface, n)}}};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const Triangles balls =
      together(ball(1, {0.013, 0.007, 0.003}, 32), ball(1, {1.2, 0.3, 0.1}, 32));
  for (const int n : {32, 64, 128})
    all.push_back(one("two balls at " + std::to_string(n), balls, n));
  if (auto horse = classic("horse.ply")) {
    for (Triangle& t : horse->triangles) std::swap(t[0], t[1]);  // the scan is inside-out
    const Box box = bounding_box(horse->positions);
    const Point by = (box.high - box.low).cwiseProduct(Point(0.013, 0.007, 0.021));
    for (const int n : {64, 128})
      all.push_back(
          one("two horses at " + std::to_string(n), together(*horse, translated(*horse, by)), n));
  }
  const Triangles legs = animal({Point::Zero(), 1, 0.035, 0.012});
  for (const int n : {64, 128})
    all.push_back(one("two animals at " + std::to_string(n),
                      together(legs, translated(legs, {0.02, 0.01, 0.015})), n));
  Case rough{"20 rough balls", {}}, tangles{"20 tangles", {}}, hostile{"300 hostile inputs", {}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    rough.inputs.push_back({tangle(seed, 12, 0.15), {}});
    tangles.inputs.push_back({tangle(seed, 8, 0.8), {}});
    for (HostileCase* c : {&rough.inputs.back(), &tangles.inputs.back()})
      c->options = cells(c->surface, 24);
  }
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    hostile.inputs.push_back(HostileCases(seed).make());
    hostile.inputs.back().options.events = Events::both;
  }
  all.insert(all.end(), {rough, tangles, hostile});
  return all;
}

}  // namespace

int main() {
  fmt::print(
      "case,collapse,inputs,remodelled,refused,pairs_before,pairs_after,old_old,old_new,"
      "new_same_cell,new_apart,triangles_after,without_area\n");
  for (const Case& c : cases())
    for (const auto& [name, collapse] : kCollapseNames) {
      Counts n;
      for (const HostileCase& input : c.inputs) count(input, collapse, n);
      fmt::print("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", c.name, name, c.inputs.size(),
                 n.operated, n.refused, n.before, n.after, n.old_old, n.old_new, n.same_cell,
                 n.apart, n.triangles, n.without_area);
      std::fflush(stdout);
    }
}
