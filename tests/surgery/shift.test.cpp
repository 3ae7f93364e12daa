// The symbolic shift and the general position that it stands for give the same table of crossings.
#include <catch2/catch.hpp>

#include "kernel/random.h"
#include "surgery/operate/triangle_pieces.h"
#include "tests/surgery/support.h"

using namespace suture;
using namespace suture::surgery;

namespace {

/// Balls and tangles with coordinates 0 to 7: vertices on nodes, lines and planes, edges in lines,
/// triangles without area, vertices in one place.
Triangles snapped(std::uint64_t seed) {
  Random random(seed);
  Triangles body =
      ball(random.uniform(0.4, 3.4), Point::Constant(3.5), static_cast<int>(1 + seed % 3));
  const double reach = seed % 4 == 0 ? 3 : seed % 4 == 1 ? 0.8 : 0;
  for (Point& p : body.positions)
    for (int a = 0; a < 3; ++a)
      p[a] = std::clamp(std::round(p[a] + random.uniform(-reach, reach)), 0.0, 7.0);
  return body;
}

/// The same surface against a lattice that is really shifted, by 2^-10, 2^-19 and 2^-28 along the
/// axes; and each vertex moved in a direction of its own by 2^-49 or nothing on each axis, so that
/// no triangle is without area. For integers up to 7 that is small enough: a determinant that is
/// not 0 is at least 1, a component of a normal at most 98, so each term is above all later ones
/// together.
Triangles in_general_position(const Triangles& surface, std::uint64_t seed) {
  Random random(seed);
  Triangles result = surface;
  constexpr double kShift[] = {0x1p-10, 0x1p-19, 0x1p-28};
  for (Point& p : result.positions)
    for (int a = 0; a < 3; ++a)
      p[a] += -kShift[a] + 0x1p-49 * (static_cast<double>(random.below(3)) - 1);
  return result;
}

struct Table {
  Incidence mesh;
  Crossings crossings;
};

Table table(const Triangles& surface, const Lattice& lattice, const Oracle& oracle) {
  Incidence mesh = incidence(surface);
  Crossings crossings = find_crossings(mesh, lattice, oracle);
  return {std::move(mesh), std::move(crossings)};
}

bool same(const LineCrossing& a, const LineCrossing& b) {
  return a.edge == b.edge && a.triangle == b.triangle && a.axis == b.axis && a.delta == b.delta;
}

Lattice integers() {
  std::vector<double> planes;
  for (int i = -4; i <= 12; ++i) planes.push_back(i);
  return Lattice({planes, planes, planes});
}

}  // namespace

TEST_CASE("a degenerate surface has the table of the same surface in general position") {
  const Lattice lattice = integers();
  const auto oracle = make_filtered_oracle();
  std::size_t flat = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Triangles surface = snapped(seed);
    const Table tied = table(surface, lattice, *oracle);
    const Table general = table(in_general_position(surface, seed), lattice, *oracle);
    CAPTURE(seed);
    REQUIRE(tied.crossings.vertex_cell == general.crossings.vertex_cell);
    REQUIRE(tied.crossings.edge_begin == general.crossings.edge_begin);
    for (std::size_t i = 0; i < tied.crossings.edge_crossings.size(); ++i)
      REQUIRE(tied.crossings.edge_crossings[i].face == general.crossings.edge_crossings[i].face);
    REQUIRE(tied.crossings.triangle_begin == general.crossings.triangle_begin);
    for (std::size_t i = 0; i < tied.crossings.line_crossings.size(); ++i)
      REQUIRE(same(tied.crossings.line_crossings[i], general.crossings.line_crossings[i]));
    REQUIRE(tied.crossings.loop_faces == general.crossings.loop_faces);
    REQUIRE(marches_agree(Winding(tied.crossings)));
    for (const Triangle& t : surface.triangles) {
      const auto& p = surface.positions;
      flat += (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]) == Point::Zero() ? 1 : 0;
    }
  }
  CHECK(flat > 1000);  // triangles without area: their lattice paths are those of their edges
}

TEST_CASE("every triangle, with or without area, is cut into cycles of three sides or more") {
  const Lattice lattice = integers();
  const auto oracle = make_filtered_oracle();
  std::size_t pieces = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Table t = table(snapped(seed), lattice, *oracle);
    for (std::uint32_t i = 0; i < t.mesh.triangles.size(); ++i) {
      const TrianglePieces cut = triangle_pieces(t.mesh, i, lattice, *oracle, t.crossings);
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
