// The lemmas of papers/proof.md, each asked directly and without the audit that would hide a fault.
#include "tests/surgery/sewn.h"

#include <catch2/catch.hpp>

#include "surgery/detect/distance_field.h"

using namespace suture;
using namespace suture::surgery;

namespace {

constexpr Events kEvents[] = {Events::both, Events::merge, Events::split};

/// A case whose events are those of `seed`, so that zones of winding 2 and −1 stay in two of three.
HostileCase with_events(std::uint64_t seed) {
  HostileCase c = HostileCases(seed).make();
  c.options.events = kEvents[seed % 3];
  return c;
}

bool on_boundary(const Region& region, int axis, LatticeId edge) {
  const int cells = region.cells_round_edge(edge, axis);
  return cells > 0 && cells < 4;
}

/// Lattice edges that the region's boundary must not have: crossed twice, or without a change of
/// side; and faces of the boundary that hold a loop.
std::size_t faults(const Detection& d) {
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const CrossedEdge& e : d.scan.winding.edges(axis))
      if (on_boundary(d.region, axis, e.edge)) count += e.count != 1 || !e.changes_side();
    for (const LatticeId face : d.scan.crossings.loop_faces[axis])
      count += d.region.holds(face) != d.region.holds(step(face, axis, -1));
  }
  return count;
}

/// Whether a node is so near the surface that the rounding of an inserted vertex may pass it.
bool near_surface(const DistanceField& distance, const Box& box, const Index3& node) {
  const double reach =
      0x1p-48 * std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  return std::abs(distance.at(node)) <= reach;
}

}  // namespace

TEST_CASE("every boundary edge of a region is crossed once at most, into or out of the material") {
  int regions = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const HostileCase c = with_events(seed);
    const Detection d = detect(c.surface, c.options);
    CAPTURE(seed);
    REQUIRE(faults(d) == 0);
    regions += d.region.empty() ? 0 : 1;
  }
  CHECK(regions > 200);
}

TEST_CASE(
    "a closed curve in the middle of a lattice face is found, and the flood passes that face") {
  const Scan s =
      scan(ball(0.3, {0, 0.5, 0.5}), 1);  // a body in two cells that meets no lattice edge
  REQUIRE(s.crossings.line_crossings.empty());
  CHECK(s.crossings.loop_faces[1].empty());
  CHECK(s.crossings.loop_faces[2].empty());
  REQUIRE(s.crossings.loop_faces[0].size() == 1);
  const LatticeId face = s.crossings.loop_faces[0].front();
  CHECK(unpack(face) == s.lattice.cell_of(Point(0.1, 0.5, 0.5)));
  const CellSet cells = find_complex_cells(s.crossings, s.winding);
  const Region region = grow_region({face}, cells);
  CHECK(region.cells.size() == 2);
  CHECK(region.holds(step(face, 0, -1)));
  CHECK(scan(ball(0.9, {0, 0.5, 0.5}), 1).crossings.loop_faces[0].empty());  // out over the edges
}

TEST_CASE("cut and fill alone give a closed manifold, cell by cell and merged") {
  std::size_t sewn = 0, split = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const HostileCase c = with_events(seed);
    const Detection d = detect(c.surface, c.options);
    if (d.region.empty()) continue;
    for (const Pieces pieces : {Pieces::cell_by_cell, Pieces::merged}) {
      const Sewn s = sew(c.surface, d, pieces, c.options.placement);
      const Audit result = audit(s.surface);
      CAPTURE(seed, static_cast<int>(pieces), result.first);
      REQUIRE(result.closed_manifold());
      if (pieces == Pieces::merged) split += s.split_triangles;
    }
    ++sewn;
  }
  WARN(split << " triangles of " << sewn << " merged cuts were split");
  CHECK(sewn > 80);
  CHECK(split > 0);
}

TEST_CASE(
    "where doubles are coarse, cells of 4 to 512 units, cut and fill still give a closed "
    "manifold") {
  std::size_t sewn = 0, objections = 0;
  for (const double offset : {0x1p42, 0x1p45, 0x1p47})
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      HostileCase c = with_events(seed);
      for (Point& p : c.surface.positions) p += Point::Constant(offset);
      c.options.origin = Point::Constant(offset);
      const Detection d = detect(c.surface, c.options);
      if (d.region.empty()) continue;
      CAPTURE(offset, seed);
      REQUIRE(audit(sew(c.surface, d, Pieces::cell_by_cell).surface).closed_manifold());
      objections += audit(sew(c.surface, d, Pieces::merged).surface).closed_manifold() ? 0 : 1;
      ++sewn;
    }
  CHECK(sewn > 60);
  CHECK(objections == 0);  // not proved where triangles are pinched: a remodel would cut again
}

TEST_CASE("cut on both sides of the region, the surface is still a closed manifold") {
  std::size_t cuts = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    const HostileCase c = with_events(seed);
    const Detection d = detect(c.surface, c.options);
    if (d.region.empty()) continue;
    for (const Pieces pieces : {Pieces::cell_by_cell, Pieces::merged}) {
      const Audit result = audit(cut_on_both_sides(c.surface, d, pieces));
      CAPTURE(seed, static_cast<int>(pieces), result.first);
      REQUIRE(result.closed_manifold());
    }
    ++cuts;
  }
  CHECK(cuts > 40);
}

TEST_CASE("two triangles at a mesh edge never both take a diagonal along it") {
  // A wedge stands with its edge on a lattice line: what the region takes from either triangle has
  // no width, so a diagonal past it, from end to end of the edge, turns no triangle over, and it is
  // the cheapest since the other corners are far.
  const Triangles wedge{{{0.5, 0, 0}, {5.5, 0, 0}, {3, 8, 8}, {3, 8, -8}},
                        {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}}};
  Detection d = detect(wedge, {.cell_size = 1, .events = Events::none});
  REQUIRE(volume(wedge) > 0);
  const Index3 at = d.scan.lattice.cell_of(Point(2.5, 0, 0));
  for (const int along : {0, 1}) d.region.cells.index(pack(at[0] + along, at[1], at[2]));
  REQUIRE(faults(d) == 0);
  const Sewn s = sew(wedge, d, Pieces::merged);
  CHECK(s.split_triangles == 0);
  CHECK(audit(s.surface).closed_manifold());
}

TEST_CASE("after a surgery that may merge and split, windings are 0 and 1 and every side stays") {
  int operated = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    HostileCase c = HostileCases(seed).make();
    c.options.events = Events::both;
    const Detection before = detect(c.surface, c.options);
    if (before.region.empty()) continue;
    ++operated;
    const Triangles sewn = sew(c.surface, before, Pieces::cell_by_cell).surface;
    const Winding after(
        find_crossings(incidence(sewn), before.scan.lattice, *before.scan.oracle, Lines::along_z));
    const DistanceField distance(c.surface, before.scan.lattice, before.scan.winding);
    const Box box = bounding_box(c.surface.positions);
    for (const Winding* crossed : {&before.scan.winding, &after})
      for (const CrossedEdge& e : crossed->edges(2))
        for (const LatticeId id : {e.edge, step(e.edge, 2, 1)}) {
          const Index3 node = unpack(id);
          const int was = before.scan.winding.at(node), is = after.at(node);
          CAPTURE(seed, node[0], node[1], node[2], was, is);
          if (is != (was >= 1 ? 1 : 0)) REQUIRE(near_surface(distance, box, node));
        }
  }
  CHECK(operated > 20);
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
      return Winding(find_crossings(incidence(t.surface()), lattice, *oracle, Lines::along_z));
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
