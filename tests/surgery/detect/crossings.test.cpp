// The symbolic shift and the general position that it stands for give the same table of crossings.
#include "surgery/detect/crossings.h"

#include <catch2/catch.hpp>

#include "surgery/detect/winding.h"
#include "tests/surgery/snapped.h"

using namespace suture;
using namespace suture::surgery;

namespace {

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

bool same(const LineCrossing& a, const LineCrossing& b) {
  return a.edge == b.edge && a.triangle == b.triangle && a.axis == b.axis && a.delta == b.delta;
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

TEST_CASE("filtered and rational arithmetic find the same crossings") {
  std::vector<Triangles> surfaces = {box({{0, 0, 0}, {2, 2, 2}, 0.5}), tangle(7), ball(1)};
  for (const Triangles& surface : surfaces) {
    const Scan a = scan(surface, 0.25), b = scan(surface, 0.25, Arithmetic::rational);
    REQUIRE(a.crossings.edge_crossings.size() == b.crossings.edge_crossings.size());
    for (std::size_t i = 0; i < a.crossings.edge_crossings.size(); ++i)
      REQUIRE(a.crossings.edge_crossings[i].face == b.crossings.edge_crossings[i].face);
    REQUIRE(a.crossings.line_crossings.size() == b.crossings.line_crossings.size());
    for (std::size_t i = 0; i < a.crossings.line_crossings.size(); ++i)
      REQUIRE(a.crossings.line_crossings[i].edge == b.crossings.line_crossings[i].edge);
  }
}
