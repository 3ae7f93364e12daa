// Pairs of triangles that pass through one another, before and after one remodel, by their causes:
// a CSV row a case on standard output.
#include <fmt/core.h>

#include <algorithm>

#include "kernel/measure/self_intersections.h"
#include "kernel/random.h"
#include "surgery/model/option_table.h"
#include "tests/models.h"
#include "tests/surgery/sewn.h"

using namespace suture;
using namespace suture::surgery;

namespace {

constexpr std::size_t kMostPairs = 2'000'000;

struct Case {
  std::string name;
  std::vector<HostileCase> inputs;
};

/// The kinds of pairs after a remodel. A triangle counts as outside or in a cell of the region by
/// where its centre is.
struct Counts {
  std::size_t operated = 0, refused = 0, before = 0, after = 0;
  std::size_t touching = 0;   ///< not deeper than 2^-48 of the extent, or gone if both shrink
  std::size_t outside = 0;    ///< of the others: both outside the region
  std::size_t beside = 0;     ///< one outside, one in it
  std::size_t same_cell = 0;  ///< both in one cell of it
  std::size_t apart = 0;      ///< in two cells of it
  std::size_t triangles = 0, without_area = 0;
};

/// How far the vertices of one triangle lie on the lesser side of the other's plane.
double reach_through(const Triangles& s, const Triangle& one, const Triangle& other) {
  const auto& p = s.positions;
  const Point normal =
      (p[other[1]] - p[other[0]]).cross(p[other[2]] - p[other[0]]).stableNormalized();
  double above = 0, below = 0;
  for (const std::uint32_t v : one) {
    const double height = normal.dot(p[v] - p[other[0]]);
    above = std::max(above, height);
    below = std::max(below, -height);
  }
  return std::min(above, below);
}

/// Whether two triangles that intersect no longer do once each is drawn towards its centre by
/// 2^-20: they touch in a vertex, an edge, or by the rounding of a vertex.
bool only_touch(const Triangles& surface, const Triangle& one, const Triangle& other) {
  constexpr double kShrink = 0x1p-20;
  Triangles two{{}, {{0, 1, 2}, {3, 4, 5}}};
  for (const Triangle& t : {one, other}) {
    const auto& p = surface.positions;
    const Point centre = p[t[0]] / 3 + p[t[1]] / 3 + p[t[2]] / 3;
    for (const std::uint32_t v : t) two.positions.push_back(p[v] + kShrink * (centre - p[v]));
  }
  return self_intersections(two).pairs.empty();
}

void count(const HostileCase& input, Collapse collapse, Counts& c) {
  TrackerOptions options = input.options;
  options.collapse = collapse;
  Tracker tracker(input.surface, options);
  const SurgeryReport report = tracker.remodel();
  c.refused += report.outcome == Outcome::refused ? 1 : 0;
  // Without copies that were dropped first, so that the region is that of the input.
  if (report.outcome != Outcome::committed || report.coincident_triangles > 0) return;
  ++c.operated;
  const Triangles& after = tracker.surface();
  const SelfIntersections found = self_intersections(after, {kMostPairs});
  c.before += self_intersections(input.surface, {kMostPairs}).pairs.size();
  c.after += found.pairs.size();
  c.triangles += after.triangles.size();
  c.without_area += found.without_area;
  if (found.pairs.empty()) return;
  const Detection d = detect(input.surface, options);
  const Lattice& lattice = d.scan.lattice;
  const auto cell = [&](std::uint32_t t) {
    const Triangle& v = after.triangles[t];
    const auto& p = after.positions;
    return pack(lattice.cell_of(Point(p[v[0]] / 3 + p[v[1]] / 3 + p[v[2]] / 3)));
  };
  const Box box = bounding_box(input.surface.positions);
  const double rounding =
      0x1p-48 * std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  for (const auto& [a, b] : found.pairs) {
    const Triangle &one = after.triangles[a], &other = after.triangles[b];
    const double depth =
        std::min(reach_through(after, one, other), reach_through(after, other, one));
    const bool touching = depth <= rounding || only_touch(after, one, other);
    const int in = (d.region.holds(cell(a)) ? 1 : 0) + (d.region.holds(cell(b)) ? 1 : 0);
    std::size_t& kind = touching             ? c.touching
                        : in == 0            ? c.outside
                        : in == 1            ? c.beside
                        : cell(a) == cell(b) ? c.same_cell
                                             : c.apart;
    ++kind;
  }
}

Triangles tangle(std::uint64_t seed, int frequency, double reach) {
  Random random(seed);
  Triangles body = ball(1, Point::Zero(), frequency);
  for (Point& p : body.positions)
    p += reach * Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
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
      "case,collapse,inputs,remodelled,refused,pairs_before,pairs_after,touching,outside,beside,"
      "same_cell,apart,triangles_after,without_area\n");
  for (const Case& c : cases())
    for (const auto& [name, collapse] : kCollapseNames) {
      Counts n;
      for (const HostileCase& input : c.inputs) count(input, collapse, n);
      fmt::print("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", c.name, name, c.inputs.size(),
                 n.operated, n.refused, n.before, n.after, n.touching, n.outside, n.beside,
                 n.same_cell, n.apart, n.triangles, n.without_area);
      std::fflush(stdout);
    }
}
