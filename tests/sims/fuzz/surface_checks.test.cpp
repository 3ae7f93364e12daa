#include <catch2/catch.hpp>
#include <cmath>

#include "kernel/errors.h"
#include "kernel/measure/measures.h"
#include "kernel/shapes/shapes.h"
#include "kernel/shapes/transform.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/execute.h"
#include "sims/fuzz/checks.h"
#include "surgery/check/surgery_check.h"
#include "surgery/tracker.h"

using namespace suture;
using namespace suture::sims;

namespace {

/// Two balls that overlap, and what a remodel makes of them: nothing is wrong, until a test says
/// so.
struct Healthy {
  TrackerOptions options;
  Triangles before, after;
  SurgeryReport surgery;

  Healthy() {
    options.cell_size = 0.31;
    options.collapse = Collapse::keep;
    before = merged(std::vector<Triangles>{sphere({Point(0.01, 0.02, 0.03), 1, 0.1, 3}),
                                           sphere({Point(1.11, 0.12, 0.23), 0.8, 0.1, 3})});
    Tracker tracker(before, options);
    surgery = tracker.remodel();
    after = tracker.surface();
  }
  Observation seen() const { return {1, options, before, after, &surgery, nullptr, true}; }
};

Triangles dented(Triangles surface) {
  surface.positions[0] *= 0.5;
  return surface;
}

}  // namespace

TEST_CASE("no oracle objects to a healthy surgery") {
  const Healthy h;
  REQUIRE(h.surgery.outcome == Outcome::committed);
  REQUIRE(count_ties(h.before, lattice_of(h.before.positions, h.options)) == 0);
  for (const FuzzOracle& oracle : fuzz_oracles()) {
    const Objection objection = oracle.object(h.seen());
    CAPTURE(oracle.name, objection.value_or(""));
    CHECK_FALSE(objection);
  }
}

TEST_CASE("the audit oracle objects to a hole, and to one vertex too many") {
  Healthy h;
  h.after.positions.emplace_back(0, 0, 0);
  CHECK(object_audit(h.seen()));
  h.after.positions.pop_back();
  h.after.triangles.pop_back();
  CHECK(object_audit(h.seen()));
}

TEST_CASE("the bits oracle objects to the sign of a zero after an unchanged or refused remodel") {
  Healthy h;
  h.before.positions[0][0] = 0.0;
  h.after = h.before;
  h.after.positions[0][0] = -0.0;
  for (const Outcome outcome : {Outcome::unchanged, Outcome::refused}) {
    h.surgery.outcome = outcome;
    CHECK(object_bits(h.seen()));
  }
  h.after = h.before;
  CHECK_FALSE(object_bits(h.seen()));
}

TEST_CASE("the map oracle objects to a survivor that moved, was doubled, or is out of range") {
  const Healthy healthy;
  std::size_t survivor = 0;
  while (healthy.surgery.vertex_map[survivor] == kNone) ++survivor;
  Healthy moved = healthy, doubled = healthy, beyond = healthy, shorter = healthy;
  moved.after.positions[moved.surgery.vertex_map[survivor]][1] += 0x1p-50;
  CHECK(object_map(moved.seen()));
  doubled.surgery.vertex_map[survivor + 1] = doubled.surgery.vertex_map[survivor];
  CHECK(object_map(doubled.seen()));
  beyond.surgery.vertex_map[survivor] = 1000000;
  CHECK(object_map(beyond.seen()));
  shorter.surgery.vertex_map.pop_back();
  CHECK(object_map(shorter.seen()));
}

TEST_CASE("marches disagree, or do not close, where plain doubles judge hostile surfaces") {
  int judged = 0, objected = 0, exact = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const FuzzCase c = make_case(seed, {Profile::hostile});
    try {
      const Lattice lattice = lattice_of(c.surface.positions, c.options);
      exact += SurfaceCheck(c.surface, lattice).marches_agree() ? 0 : 1;
      ++judged;
      objected += SurfaceCheck(c.surface, lattice, Arithmetic::rounded).marches_agree() ? 0 : 1;
    } catch (const InternalFailure&) {
      ++objected;
    } catch (const InvalidInput&) {  // no lattice for it
    }
  }
  CHECK(judged > 200);
  CHECK(objected > 10);
  CHECK(exact == 0);
}

TEST_CASE("the invariance oracle objects to a node that a dent left outside") {
  Healthy h;
  h.surgery.region.clear();
  h.after = dented(h.before);
  CHECK(object_invariance(h.seen()));
  h.after = h.before;
  CHECK_FALSE(object_invariance(h.seen()));
}

TEST_CASE("the settled oracle objects to a second surgery, but not with the plain test") {
  Healthy h;
  Observation o = h.seen();
  o.moved = false;
  CHECK(object_settled(o));
  h.surgery.region.clear();  // copies were dropped, nothing was re-sampled
  CHECK_FALSE(object_settled(o));
  h.surgery.region.push_back(0);
  h.options.cell_test = CellTest::plain;
  CHECK_FALSE(object_settled(o));
}

TEST_CASE("a winding that is off by one is not the solid angle") {
  const Healthy h;
  const Lattice lattice = lattice_of(h.after.positions, h.options);
  const Index3 middle = lattice.cell_of(Point(0.01, 0.02, 0.03));
  CHECK_FALSE(compare_winding(h.after, lattice, middle, 1));
  CHECK(compare_winding(h.after, lattice, middle, 2));
  CHECK(compare_winding(h.after, lattice, middle, 0));
  CHECK_FALSE(compare_winding(h.after, lattice, {0, 0, 0}, 0));
}

TEST_CASE("twins object to one bit of the surface, or one more event") {
  Healthy bit;
  for (Point& p : bit.after.positions)
    if (p[0] > 1) p[0] = std::nextafter(p[0], 9.0);
  for (const auto object : {object_rational, object_scaling, object_axes, object_order})
    CHECK(object(bit.seen()));
  Healthy event;
  ++event.surgery.marked.deep_inside;
  for (const auto object : {object_rational, object_scaling, object_axes, object_order})
    CHECK(object(event.seen()));
}

TEST_CASE("moved by whole cells, a surface meets the lattice as before") {
  Healthy h;  // with these numbers every move is exact
  h.options.cell_size = 0.25;
  for (Point& p : h.before.positions)
    for (int a = 0; a < 3; ++a) p[a] = std::round(p[a] * 0x1p20) * 0x1p-20;
  Tracker tracker(h.before, h.options);
  h.surgery = tracker.remodel();
  h.after = tracker.surface();
  CHECK_FALSE(object_cells(h.seen()));
  ++h.surgery.loops;
  CHECK(object_cells(h.seen()));
  --h.surgery.loops;
  h.after.positions[0][0] = std::nextafter(h.after.positions[0][0], 9.0);
  CHECK(object_cells(h.seen()));
}

TEST_CASE("ties are counted where vertices, edges and triangles meet planes, lines and nodes") {
  const Triangles off = sphere({Point(0.01, 0.02, 0.03), 1, 0.1, 3});
  TrackerOptions options;
  options.cell_size = 0.25;
  CHECK(count_ties(off, lattice_of(off.positions, options)) == 0);
  const Triangles on_planes = box({Point::Zero(), Point::Constant(1), 1});
  CHECK(count_ties(on_planes, lattice_of(on_planes.positions, options)) > 8);
}

TEST_CASE("names choose oracles; unknown ones are refused, and sampling follows the seed") {
  const auto asked = [](const OracleChoice& choice, std::uint64_t seed) {
    std::string names;
    for (const FuzzOracle& oracle : fuzz_oracles())
      if (choice.asks(oracle, seed)) names += std::string(names.empty() ? "" : ",") + oracle.name;
    return names;
  };
  CHECK(asked(OracleChoice("axes,audit"), 1) == "audit,axes");
  CHECK(asked(OracleChoice("fast"), 1) == "audit,bits,map,marches,invariance,settled");
  CHECK_THROWS_AS(OracleChoice("axes,tarot"), InvalidInput);
  CHECK_THROWS_AS(OracleChoice(""), InvalidInput);
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 6400; ++seed)
    all += asked(OracleChoice(), seed) == asked(OracleChoice("all"), seed) ? 1 : 0;
  CHECK(all > 60);
  CHECK(all < 150);
}
