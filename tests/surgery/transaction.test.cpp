#include <array>
#include <catch2/catch.hpp>
#include <cfenv>
#include <map>
#include <thread>

#include "kernel/errors.h"
#include "surgery/detect/invariance.h"
#include "surgery/remodel.h"
#include "tests/brute/lying_runs.h"
#include "tests/surgery/hostile.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

TEST_CASE("under an oracle that lies, a remodel refuses or commits a closed manifold, never junk") {
  std::map<double, LyingRun> sum;
  for (std::uint64_t seed = 1; seed <= 2500; ++seed) {
    const LyingRun run = run_lying(seed);
    CAPTURE(seed, run.probability);
    CHECK(run.fault == "");
    LyingRun& s = sum[run.probability];
    s.committed += run.committed;
    s.refused += run.refused;
    s.improved += run.improved;
  }
  for (const auto& [probability, s] : sum) {
    CAPTURE(probability);
    CHECK((s.refused > 0 || probability < 1e-3));
    CHECK((s.committed > 20 || probability > 1e-3));
    CHECK((s.committed > 0 || probability > 0.01));
    CHECK(s.improved > 0);
  }
}

TEST_CASE("the audit sees a change of winding outside the region, and inside it") {
  const Triangles before = ball(1, {0.01, 0.02, 0.03}, 6);
  Triangles after = before;
  after.positions[0] *= 0.7;  // a dent
  std::vector<std::uint32_t> kept(before.triangles.size()), map(before.positions.size());
  for (std::uint32_t t = 0; t < kept.size(); ++t) kept[t] = t;
  for (std::uint32_t v = 0; v < map.size(); ++v) map[v] = v;
  for (std::uint32_t t = 0; t < kept.size(); ++t)
    for (const auto v : before.triangles[t])
      if (v == 0) kept[t] = kNone;
  map[0] = kNone;
  const Triangles change = difference(before, after, {kept, map});
  CHECK(change.triangles.size() == 10);  // five triangles round a corner of the icosahedron, twice

  const Scan s = scan(before, 0.02);
  Region none, all;
  CHECK_FALSE(wrongly_changed(change, {s.mesh, s.on(), s.crossings, s.winding, none}).empty());
  for (int i = 0; i < s.lattice.cells(0); ++i)
    for (int j = 0; j < s.lattice.cells(1); ++j)
      for (int k = 0; k < s.lattice.cells(2); ++k) all.cells.index(pack(i, j, k));
  CHECK_FALSE(wrongly_changed(change, {s.mesh, s.on(), s.crossings, s.winding, all}).empty());
}

TEST_CASE("what the audit rejects is not committed, wherever the fault came from") {
  const Triangles two = together(ball(1, {0.01, 0.02, 0.03}, 6), ball(1, {1.2, 0.3, 0.1}, 6));
  Surface surface{to_mesh(two), two};
  const auto corner = [&](double x) { return surface.mesh.add_vertex(CgalPoint(x, 0.11, 0.11)); };
  surface.mesh.add_face(corner(0.11), corner(0.12), corner(0.13));  // open, and in one cell
  const auto oracle = make_filtered_oracle();
  const TrackerOptions options{.cell_size = 0.2};
  const SurgeryReport report = remodel(surface, {options, *oracle});
  CHECK(report.outcome == Outcome::refused);
  CHECK_THAT(report.failure, Catch::Matchers::Contains("audit: 3 border edges"));
  CHECK(surface.triangles == two);
}

TEST_CASE("hostile surgeries agree bit for bit under both arithmetics") {
  int operated = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    HostileCase c = HostileCases(seed).make();
    Tracker filtered(c.surface, c.options);
    const SurgeryReport report = filtered.remodel();
    c.options.arithmetic = Arithmetic::rational;
    Tracker rational(c.surface, c.options);
    rational.remodel();
    CAPTURE(seed);
    CHECK(filtered.surface() == rational.surface());
    operated += report.outcome == Outcome::committed ? 1 : 0;
  }
  CHECK(operated > 40);
}

TEST_CASE("the same input gives the same bits and the same report") {
  const HostileCase c = HostileCases(11).make();
  Tracker one(c.surface, c.options), two(c.surface, c.options);
  const SurgeryReport a = one.remodel(), b = two.remodel();
  CHECK(a.outcome == Outcome::committed);
  CHECK(one.surface() == two.surface());
  CHECK(a.marked.total() == b.marked.total());
  CHECK(a.vertex_map == b.vertex_map);
  CHECK(a.oracle.edge_side == b.oracle.edge_side);
}

TEST_CASE("two threads that share an oracle get the bits and the counts of one alone") {
  const auto oracle = make_filtered_oracle();
  const auto remodelled = [&](std::uint64_t seed) {
    const HostileCase c = HostileCases(seed).make();
    Surface surface{to_mesh(c.surface), c.surface};
    SurgeryReport report = remodel(surface, {c.options, *oracle});
    return std::pair(std::move(surface.triangles), report.oracle);
  };
  const auto counted = [](const OracleCounts& c) {
    return std::array{c.edge_side, c.triangle_side, c.orientation, c.filter_failures};
  };
  std::size_t straightened = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto alone = remodelled(seed), other = remodelled(seed + 20);
    std::pair<Triangles, OracleCounts> here, there;
    std::thread thread([&] { there = remodelled(seed + 20); });
    here = remodelled(seed);
    thread.join();
    CAPTURE(seed);
    CHECK(here.first == alone.first);
    CHECK(there.first == other.first);
    CHECK(counted(here.second) == counted(alone.second));
    CHECK(counted(there.second) == counted(other.second));
    straightened += alone.second.orientation > 0 ? 1 : 0;  // which asks for orientations
  }
  CHECK(straightened > 5);
}

TEST_CASE("a tracker does nothing on a thread that rounds other than to nearest") {
  const HostileCase c = HostileCases(11).make();
  Tracker tracker(c.surface, c.options);
  int refused = 0;
  std::fesetround(FE_UPWARD);
  try {
    tracker.remodel();
  } catch (const InvalidInput&) {
    ++refused;
  }
  try {
    tracker.improve();
  } catch (const InvalidInput&) {
    ++refused;
  }
  std::fesetround(FE_TONEAREST);
  CHECK(refused == 2);
  CHECK(tracker.surface() == c.surface);
  CHECK(tracker.remodel().outcome == Outcome::committed);
}
