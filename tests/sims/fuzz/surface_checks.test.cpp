#include <catch2/catch.hpp>

#include "kernel/errors.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/surface_checks.h"
#include "surgery/check/surgery_check.h"
#include "tests/sims/fuzz/healthy.h"

using namespace suture;
using namespace suture::sims;

namespace {

Triangles dented(Triangles surface) {
  surface.positions[0] *= 0.5;
  return surface;
}

}  // namespace

TEST_CASE("the audit check objects to a hole, and to one vertex too many") {
  Healthy h;
  h.after.positions.emplace_back(0, 0, 0);
  CHECK(check_audit(h.seen()));
  h.after.positions.pop_back();
  h.after.triangles.pop_back();
  CHECK(check_audit(h.seen()));
}

TEST_CASE("the bits check objects to the sign of a zero after an unchanged or refused remodel") {
  Healthy h;
  h.before.positions[0][0] = 0.0;
  h.after = h.before;
  h.after.positions[0][0] = -0.0;
  for (const Outcome outcome : {Outcome::unchanged, Outcome::refused}) {
    h.surgery.outcome = outcome;
    CHECK(check_bits(h.seen()));
  }
  h.after = h.before;
  CHECK_FALSE(check_bits(h.seen()));
}

TEST_CASE("the map check objects to a survivor that moved, was doubled, or is out of range") {
  const Healthy healthy;
  std::size_t survivor = 0;
  while (healthy.surgery.vertex_map[survivor] == kNone) ++survivor;
  Healthy moved = healthy, doubled = healthy, beyond = healthy, shorter = healthy;
  moved.after.positions[moved.surgery.vertex_map[survivor]][1] += 0x1p-50;
  CHECK(check_map(moved.seen()));
  doubled.surgery.vertex_map[survivor + 1] = doubled.surgery.vertex_map[survivor];
  CHECK(check_map(doubled.seen()));
  beyond.surgery.vertex_map[survivor] = 1000000;
  CHECK(check_map(beyond.seen()));
  shorter.surgery.vertex_map.pop_back();
  CHECK(check_map(shorter.seen()));
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

TEST_CASE("the invariance check objects to a node that a dent left outside") {
  Healthy h;
  h.surgery.region.clear();
  h.after = dented(h.before);
  CHECK(check_invariance(h.seen()));
  h.after = h.before;
  CHECK_FALSE(check_invariance(h.seen()));
}

TEST_CASE("the settled check objects to a second surgery, but not with the plain test") {
  Healthy h;
  Observation o = h.seen();
  o.moved = false;
  CHECK(check_settled(o));
  h.surgery.region.clear();  // copies were dropped, nothing was re-sampled
  CHECK_FALSE(check_settled(o));
  h.surgery.region.push_back(0);
  h.options.cell_test = CellTest::plain;
  CHECK_FALSE(check_settled(o));
}

TEST_CASE("a winding that is off by one is not the solid angle") {
  const Healthy h;
  const Lattice lattice = lattice_of(h.after.positions, h.options);
  const Index3 middle = lattice.cell_of(Point(0.01, 0.02, 0.03));
  CHECK_FALSE(compare_winding(h.after, lattice, {middle, 1}));
  CHECK(compare_winding(h.after, lattice, {middle, 2}));
  CHECK(compare_winding(h.after, lattice, {middle, 0}));
  CHECK_FALSE(compare_winding(h.after, lattice, {{0, 0, 0}, 0}));
}
