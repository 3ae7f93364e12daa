#include "tests/surgery/hostile.h"

#include <catch2/catch.hpp>
#include <set>

#include "kernel/formats/mesh_io.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

std::string saved(const Triangles& surface, std::uint64_t seed) {
  const std::string name = "hostile_" + std::to_string(seed) + ".ply";
  write_triangles(name, surface);
  return name;
}

/// Remodels, audits, remodels the output again. \return whether there was anything to do
bool survive(std::uint64_t seed) {
  const HostileCase c = HostileCases(seed).make();
  Tracker tracker(c.surface, c.options);
  bool operated = false;
  for (int round = 0; round < 3; ++round) {
    const Triangles before = tracker.surface();
    SurgeryReport report;
    try {
      report = tracker.remodel();
    } catch (const std::exception& error) {
      CAPTURE(seed, round, error.what(), saved(before, seed));
      CHECK(false);
      return operated;
    }
    const Audit result = tracker.surface().triangles.empty() ? Audit{} : audit(tracker.surface());
    const bool good = report.outcome != Outcome::refused && result.closed_manifold();
    if (!good) {
      CAPTURE(seed, round, report.failure, result.first, saved(before, seed));
      CHECK(good);
      return operated;
    }
    operated |= report.outcome == Outcome::committed;
    if (report.outcome == Outcome::unchanged) {
      CHECK(tracker.surface() == before);
      break;
    }
    if (tracker.surface().triangles.empty()) break;
  }
  if (!tracker.surface().triangles.empty()) {
    const Scan s = scan(tracker.surface(), c.options.cell_size);
    CAPTURE(seed);
    CHECK(marches_agree(s.winding));
  }
  return operated;
}

}  // namespace

TEST_CASE("three hundred hostile surgeries leave closed manifolds, under sanitizers too") {
  int operated = 0;
  for (std::uint64_t seed = 3001; seed <= 3300; ++seed) operated += survive(seed) ? 1 : 0;
  CHECK(operated >= 180);
}

TEST_CASE("three thousand random and hostile surgeries each leave a closed manifold", "[slow]") {
  int operated = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) operated += survive(seed) ? 1 : 0;
  WARN(operated << " of 3000 inputs needed surgery");
  CHECK(operated >= 2000);
}

TEST_CASE("improving what hostile surgeries leave keeps it a closed manifold") {
  for (const std::uint64_t seed : {10003, 10007, 10026, 10031, 10042, 10058}) {
    HostileCase c = HostileCases(seed).make();
    c.options.quality.edge_length = 0.5;
    Tracker tracker(c.surface, c.options);
    tracker.remodel();
    tracker.improve();
    CAPTURE(seed);
    if (!tracker.surface().triangles.empty()) CHECK(audit(tracker.surface()).closed_manifold());
  }
}

TEST_CASE("straightening moves no node of the lattice to another winding") {
  std::size_t collapsed = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    HostileCase c = HostileCases(seed).make();
    c.options.collapse = Collapse::keep;
    Tracker kept(c.surface, c.options);
    if (kept.remodel().outcome != Outcome::committed || kept.surface().triangles.empty()) continue;
    c.options.collapse = Collapse::straighten;
    Tracker straight(c.surface, c.options);
    const SurgeryReport report = straight.remodel();
    collapsed += report.collapses.done;
    refused += report.collapses.refused_node;
    const Lattice lattice = tracker_lattice(c.surface.positions, c.options);
    const auto oracle = make_oracle(c.options.arithmetic);
    const auto windings = [&](const Tracker& t) {
      return Winding(find_crossings(incidence(t.surface()), {lattice, *oracle}, Lines::along_z));
    };
    const Winding a = windings(kept), b = windings(straight);
    CAPTURE(seed);
    for (const Winding* crossed : {&a, &b})
      for (const CrossedEdge& e : crossed->edges(2))
        for (const LatticeId id : {e.edge, step(e.edge, 2, 1)})
          REQUIRE(a.at(unpack(id)) == b.at(unpack(id)));
  }
  CHECK(collapsed > 1000);
  CHECK(refused > 0);
}
