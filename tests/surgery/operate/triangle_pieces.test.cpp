#include "surgery/operate/triangle_pieces.h"

#include <catch2/catch.hpp>

#include "tests/surgery/snapped.h"

using namespace suture;
using namespace suture::surgery;

TEST_CASE("every triangle, with or without area, is cut into cycles of three sides or more") {
  const Lattice lattice = integers();
  const auto oracle = make_filtered_oracle();
  std::size_t pieces = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Table t = table(snapped(seed), lattice, *oracle);
    for (std::uint32_t i = 0; i < t.mesh.triangles.size(); ++i) {
      const TrianglePieces cut = triangle_pieces({t.mesh, {lattice, *oracle}, t.crossings}, i);
      std::size_t on_edges = 0, twins = 0;
      for (const PieceSide& s : cut.sides) {
        REQUIRE(s.next != kNone);
        REQUIRE(cut.sides[s.next].from == s.to);
        on_edges += s.neighbour == kNoCell ? 1 : 0;
        if (s.neighbour == kNoCell) continue;
        ++twins;
        REQUIRE(cut.sides[s.twin].twin != kNone);
        REQUIRE(cut.sides[s.twin].from == s.to);
      }
      REQUIRE(on_edges == 3 + cut.edge_sites.size());
      REQUIRE(twins == cut.sides.size() - on_edges);
      // Euler: sites − sides + cells = 1, a side between two cells being counted once.
      std::size_t cells = 0;
      for (std::size_t s = 0; s < cut.sides.size(); ++s)
        cells += s == 0 || cut.sides[s].cell != cut.sides[s - 1].cell ? 1 : 0;
      REQUIRE(3 + cut.edge_sites.size() + cut.line_sites.size() + cells ==
              1 + on_edges + twins / 2);
      pieces += cells;
    }
  }
  CHECK(pieces > 5000);
}
