// The lemmas of papers/proof.md on the region, asked directly: an audit would hide a fault.
#include "surgery/detect/region.h"

#include <catch2/catch.hpp>

#include "tests/surgery/sewn.h"

using namespace suture;
using namespace suture::surgery;

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
