// The three orders of collapses on the same inputs: a CSV row an input and order on standard
// output. usage: collapse_bench [hostile seeds]
#include <fmt/core.h>
#include <sys/resource.h>

#include <cstdlib>
#include <map>

#include "kernel/measure/self_intersections.h"
#include "surgery/model/tracker_lattice.h"
#include "tests/models.h"
#include "tests/surgery/hostile.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

struct Input {
  Triangles surface;
  TrackerOptions options;
};

/// The row adds up what one order did to some inputs.
struct Row {
  std::size_t inputs = 0, committed = 0, refused = 0, type2 = 0, left = 0, bent = 0, restarts = 0,
              blocked = 0, delayed = 0, link = 0, normal = 0, node = 0, seeds = 0, grown = 0,
              collateral = 0, pairs = 0, triangles = 0;
  double seconds = 0;
};

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

using EdgeCounts = std::array<std::map<LatticeId, int>, 3>;

EdgeCounts crossings_on_edges(const Triangles& surface, const Lattice& lattice) {
  EdgeCounts counts;
  if (surface.triangles.empty()) return counts;
  const auto oracle = make_filtered_oracle();
  for (const LineCrossing& x :
       find_crossings(incidence(surface), {lattice, *oracle}).line_crossings)
    ++counts[x.axis][x.edge];
  return counts;
}

/// Crossings that came or went on lattice edges without a re-sampled cell: what collapses moved.
std::size_t collateral(const Triangles& before, const Triangles& after, const SurgeryReport& report,
                       const TrackerOptions& options) {
  SparseField<char> region;
  for (const LatticeId cell : report.region) region.index(cell);
  const Lattice lattice = tracker_lattice(before.positions, options);
  EdgeCounts was = crossings_on_edges(before, lattice), is = crossings_on_edges(after, lattice);
  std::size_t changed = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const auto& [edge, count] : was[axis]) is[axis][edge] -= count;
    for (const auto& [edge, change] : is[axis]) {
      bool touches = false;
      cells_round_edge(edge, axis, [&](LatticeId cell) { touches |= region.contains(cell); });
      if (!touches) changed += static_cast<std::size_t>(std::abs(change));
    }
  }
  return changed;
}

void run(const Input& input, Row& row) {
  const TrackerOptions& options = input.options;
  Tracker tracker(input.surface, options);
  const double start = cpu_seconds();
  const SurgeryReport r = tracker.remodel();
  row.seconds += cpu_seconds() - start;
  ++row.inputs;
  row.refused += r.outcome == Outcome::refused ? 1 : 0;
  row.bent += r.bent_arcs;
  row.restarts += r.regrowths;
  row.blocked += r.collapses.blocked;
  row.grown += r.marked.gridlocked;
  row.seeds += r.marked.total() - r.marked.gridlocked;
  row.delayed += r.collapses.delayed;
  row.link += r.collapses.refused_link;
  row.normal += r.collapses.refused_normal;
  row.node += r.collapses.refused_node;
  if (r.outcome != Outcome::committed) return;
  ++row.committed;
  row.type2 += r.type2_vertices;
  if (options.collapse != Collapse::paper) row.left += r.type2_vertices - r.collapses.done;
  row.triangles += tracker.surface().triangles.size();
  if (r.coincident_triangles == 0)
    row.collateral += collateral(input.surface, tracker.surface(), r, options);
  row.pairs += self_intersections(tracker.surface(), {.most = 100000}).pairs.size();
}

void compare(const std::string& name, const std::vector<Input>& inputs) {
  struct Order {
    const char* name;
    Collapse collapse;
    double turn;  // degrees; at 180 only turning a triangle over is refused
  };
  constexpr Order kOrders[] = {{"keep", Collapse::keep, 60},
                               {"straighten", Collapse::straighten, 60},
                               {"paper", Collapse::paper, 60},
                               {"paper at 180 degrees", Collapse::paper, 180}};
  for (const Order& order : kOrders) {
    Row r;
    for (Input input : inputs) {
      input.options.collapse = order.collapse;
      input.options.straighten_turn = order.turn;
      run(input, r);
    }
    fmt::print("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.3f}\n", name,
               order.name, r.inputs, r.committed, r.refused, r.type2, r.left, r.bent, r.restarts,
               r.blocked, r.delayed, r.link, r.normal, r.node, r.seeds, r.grown, r.collateral,
               r.pairs, r.triangles, r.seconds);
    std::fflush(stdout);
  }
}

std::vector<Input> overlapping(const Triangles& body, const Point& by, int cells) {
  const Box box = bounding_box(body.positions);
  const Triangles two = together(body, translated(body, (box.high - box.low).cwiseProduct(by)));
  const Box both = bounding_box(two.positions);
  return {{two, {.cell_size = (both.high - both.low).maxCoeff() / cells}}};
}

std::vector<Input> tangles(int count) {
  std::vector<Input> inputs;
  for (int seed = 1; seed <= count; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Triangles body = ball(1, {0.013, 0.007, 0.003}, 12);
    for (Point& p : body.positions)
      for (double& x : p) x += random.uniform(-0.3, 0.3);
    inputs.push_back({body, {.cell_size = 0.1}});
  }
  return inputs;
}

std::vector<Input> hostile(int count) {
  std::vector<Input> inputs;
  for (int seed = 1; seed <= count; ++seed) {
    HostileCase c = HostileCases(static_cast<std::uint64_t>(seed)).make();
    inputs.push_back({std::move(c.surface), c.options});
  }
  return inputs;
}

}  // namespace

int main(int count, char** arguments) {
  const int seeds = count > 1 ? std::max(1, std::atoi(arguments[1])) : 1000;
  fmt::print(
      "case,order,inputs,committed,refused,type2_vertices,type2_left,bent_arcs,restarts,"
      "blocked_attempts,left_premature,left_link,left_normal,left_node,cells_of_first_region,cells_"
      "grown,collateral_crossings,"
      "self_intersections_after,triangles_after,cpu_seconds\n");
  for (const int cells : {64, 128, 192}) {
    if (auto horse = classic("horse.ply")) {
      for (Triangle& t : horse->triangles) std::swap(t[0], t[1]);  // the scan is inside-out
      compare(fmt::format("two horses at {}", cells),
              overlapping(*horse, {0.013, 0.007, 0.021}, cells));
    }
    compare(fmt::format("two animals at {}", cells),
            overlapping(animal({Point::Zero(), 1, 0.035, 0.01}), {0.012, 0.01, 0.03}, cells));
  }
  for (const int cells : {16, 32, 64})
    compare(fmt::format("two balls at {}", cells),
            overlapping(ball(1, {0.013, 0.007, 0.003}, 32), {0.6, 0.15, 0.05}, cells));
  compare("20 tangles", tangles(20));
  compare(fmt::format("{} hostile", seeds), hostile(seeds));
}
