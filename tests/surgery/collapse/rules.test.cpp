#include "surgery/collapse/edge_collapse.h"

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "surgery/collapse/local_change.h"
#include "tests/surgery/quality_bodies.h"

using namespace suture;
using namespace suture::surgery;
using namespace suture::bodies;

namespace {

using Vertex = Mesh::Vertex_index;

/// A closed double cone over a ring near z = 0: centre 0 above, 1 far below, the ring from 2 on.
Triangles double_cone(const std::vector<Point>& ring, double top) {
  Triangles s{{{0, 0, top}, {0, 0, -2}}, {}};
  const auto n = static_cast<std::uint32_t>(ring.size());
  s.positions.insert(s.positions.end(), ring.begin(), ring.end());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % n;
    s.triangles.push_back({0, a, b});
    s.triangles.push_back({1, b, a});
  }
  return s;
}

std::vector<Point> hexagon() {
  return {{1, 0, 0}, {0.5, 0.9, 0}, {-0.5, 0.9, 0}, {-1, 0, 0}, {-0.5, -0.9, 0}, {0.5, -0.9, 0}};
}

Refusal centre_onto_ring(const Triangles& s, const CollapseRules& rules) {
  const Mesh mesh = to_mesh(s);
  return may_collapse(mesh, mesh.halfedge(Vertex(0), Vertex(2)), rules);
}

Vertex vertex_at(const Mesh& mesh, const Point& p) {
  for (const auto v : mesh.vertices())
    if (to_point(mesh.point(v)) == p) return v;
  FAIL("no vertex there");
  return {};
}

Refusal between(const Mesh& mesh, const Point& from, const Point& to, const CollapseRules& rules) {
  return may_collapse(mesh, mesh.halfedge(vertex_at(mesh, from), vertex_at(mesh, to)), rules);
}

}  // namespace

TEST_CASE("a collapse keeps the target of the halfedge, with its index and position") {
  const Mesh ball_mesh = to_mesh(ball(1));
  for (const auto h : ball_mesh.halfedges()) {
    Mesh mesh = ball_mesh;
    REQUIRE(may_collapse(mesh, h, {.cos_turn = 0}) == Refusal::none);
    const auto gone = mesh.source(h), stays = mesh.target(h);
    const CgalPoint at = mesh.point(stays);
    CHECK(collapse(mesh, h) == stays);
    CHECK(mesh.is_removed(gone));
    CHECK(mesh.point(stays) == at);
    CHECK(mesh.number_of_faces() == ball_mesh.number_of_faces() - 2);
    CHECK(audit(to_triangles(mesh)).closed_manifold());
  }
}

TEST_CASE("a collapse that would pinch a tube is refused, and one in a wider tube is not") {
  const CollapseRules loose{.cos_turn = -1};
  const Mesh narrow = to_mesh(drum(3, 3)), wide = to_mesh(drum(5, 3));
  CHECK(may_collapse(narrow, narrow.halfedge(Vertex(3), Vertex(4)), loose) == Refusal::link);
  CHECK(may_collapse(wide, wide.halfedge(Vertex(5), Vertex(6)), loose) != Refusal::link);
}

TEST_CASE("no edge of a tetrahedron may be collapsed, since its component would vanish") {
  const Mesh mesh = to_mesh(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}});
  for (const auto h : mesh.halfedges())
    CHECK(may_collapse(mesh, h, {.cos_turn = -1}) == Refusal::link);
}

TEST_CASE("a collapse that turns a triangle over is refused, and its convex twin is not") {
  auto dented = hexagon();
  dented[1] = {0.3, 0.3, 0};  // from corner 0 the ring's second edge is seen from behind
  dented[2] = {0.5, 2, 0};
  CHECK(centre_onto_ring(double_cone(hexagon(), 0), {}) == Refusal::none);
  CHECK(centre_onto_ring(double_cone(dented, 0), {}) == Refusal::normal);
  CHECK(centre_onto_ring(double_cone(dented, 0), {.cos_turn = -1}) == Refusal::normal);
}

TEST_CASE("a normal may turn up to the bound and no further") {
  // the side of the cone stands at atan(1 / 0.9), about 48 degrees, and ends flat
  const auto steep = double_cone(hexagon(), 1);
  CHECK(centre_onto_ring(steep, {.cos_turn = std::cos(60 * std::numbers::pi / 180)}) ==
        Refusal::none);
  CHECK(centre_onto_ring(steep, {.cos_turn = std::cos(40 * std::numbers::pi / 180)}) ==
        Refusal::normal);
}

TEST_CASE("a triangle without area has no normal to keep, but may not grow up turned over") {
  auto s = double_cone(hexagon(), 0);
  s.positions[4] = {-0.5, 0, 0};  // on the line from the centre to the ring's next corner
  s.positions[5] = {-1, 0, 0};
  CHECK(centre_onto_ring(s, {}) == Refusal::none);
  s.positions[4] = {-1.5, 0, 0};  // beyond it: seen from corner 0 the triangle would be turned over
  s.positions[4][1] = 0;
  s.positions[3] = {-0.5, 1.2, 0};
  s.positions[5] = {-0.7, 0, 0};
  const Mesh mesh = to_mesh(s);
  const auto h = mesh.halfedge(Vertex(0), Vertex(7));
  CHECK(may_collapse(mesh, h, {}) == Refusal::normal);
}

TEST_CASE("a collapse that sweeps a lattice node is refused, and beside the node it is not") {
  const auto oracle = make_filtered_oracle();
  const auto cone = double_cone(hexagon(), 0.5);
  const auto refusal = [&](double x, double z) {
    const Lattice lattice({{{-3, x, 3}, {-3, 0.01, 3}, {-3, z, 3}}});
    const ShiftedLattice nodes{lattice, *oracle};
    return centre_onto_ring(cone, {.nodes = &nodes});
  };
  CHECK(refusal(0.1, 0.2) == Refusal::node);
  CHECK(refusal(0.1, 0.6) == Refusal::none);   // above the cone
  CHECK(refusal(0.1, -0.1) == Refusal::none);  // below the ring
  CHECK(refusal(0.1, 0) == Refusal::node);     // on the ring's plane: the shift puts it above
  const Lattice lattice({{{-3, 0.1, 3}, {-3, 0.01, 3}, {-3, 0.2, 3}}});
  const Mesh mesh = to_mesh(cone);
  const auto sweeps_node = [&](const Point& to) {  // as the centre moves there
    std::vector<Tetrahedron> swept;
    for (const auto h : mesh.halfedges_around_target(mesh.halfedge(Vertex(0))))
      swept.push_back({to_point(mesh.point(Vertex(0))), to,
                       to_point(mesh.point(mesh.target(mesh.next(h)))),
                       to_point(mesh.point(mesh.source(h)))});
    return any_holds_node(swept, {lattice, *oracle});
  };
  CHECK(sweeps_node({1, 0, 0}));
  CHECK_FALSE(sweeps_node({0, 0, 0.4}));
}

TEST_CASE("more volume than the bound is refused, and less is not") {
  // the cone's apex falls by 0.2 over a ring of area 2.7: it moves at least a third of the product
  const auto cone = double_cone(hexagon(), 0.2);
  CHECK(centre_onto_ring(cone, {.volume_bound = 0.17}) == Refusal::volume);
  CHECK(centre_onto_ring(cone, {.volume_bound = 0.19}) == Refusal::none);
}

TEST_CASE("corners stay, and vertices of an edge move only along it") {
  const Mesh mesh = to_mesh(cube(2));
  const CollapseRules kept{.cos_turn = -1, .cos_feature = std::cos(40 * std::numbers::pi / 180)};
  const CollapseRules loose{.cos_turn = -1};
  const Point corner(0, 0, 0), on_edge(0.25, 0, 0), further(0.5, 0, 0), in_face(0.25, 0.25, 0),
      deeper(0.5, 0.5, 0);
  CHECK(between(mesh, corner, on_edge, kept) == Refusal::feature);
  CHECK(between(mesh, corner, on_edge, loose) == Refusal::none);
  CHECK(between(mesh, on_edge, corner, kept) == Refusal::none);
  CHECK(between(mesh, on_edge, further, kept) == Refusal::none);
  CHECK(between(mesh, on_edge, in_face, kept) == Refusal::feature);
  CHECK(between(mesh, on_edge, in_face, loose) == Refusal::none);
  CHECK(between(mesh, in_face, on_edge, kept) == Refusal::none);
  CHECK(between(mesh, in_face, deeper, kept) == Refusal::none);
}

TEST_CASE("whatever the rules allow leaves a closed manifold, on hostile meshes too") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Dice dice(seed);
    Mesh mesh = to_mesh(tormented(seed % 2 ? ball(2) : drum(12, 6), dice, 0.2));
    const CollapseRules rules{.cos_turn = seed % 3 ? -1. : 0.5};
    std::size_t done = 0;
    for (int i = 0; i < 1000; ++i) {
      const Mesh::Halfedge_index h(static_cast<Mesh::size_type>(dice.below(mesh.num_halfedges())));
      if (mesh.is_removed(h) || may_collapse(mesh, h, rules) != Refusal::none) continue;
      collapse(mesh, h);
      ++done;
      if (done % 10 == 0) REQUIRE(audit(to_triangles(mesh)).closed_manifold());
    }
    CHECK(done > 20);
    REQUIRE(audit(to_triangles(mesh)).closed_manifold());
  }
}

TEST_CASE("our link condition is CGAL's, and no vertex is left with two triangles") {
  std::size_t kept = 0, broken = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Dice dice(seed);
    Mesh mesh = to_mesh(tormented(seed % 2 ? ball(2) : drum(5, 6), dice, 0.2));
    for (int round = 0; round < 60; ++round) {
      const Mesh::Halfedge_index h(static_cast<Mesh::size_type>(dice.below(mesh.num_halfedges())));
      if (!mesh.is_removed(h) && keeps_manifold(mesh, h)) collapse(mesh, h);
      for (const auto g : mesh.halfedges()) {
        const auto left = mesh.target(mesh.next(g)),
                   right = mesh.target(mesh.next(mesh.opposite(g)));
        const bool keeps = CGAL::Euler::does_satisfy_link_condition(mesh.edge(g), mesh) &&
                           left != right && mesh.degree(left) > 3 && mesh.degree(right) > 3;
        if (keeps_manifold(mesh, g) != keeps) FAIL("halfedge " << g << " of seed " << seed);
        ++(keeps ? kept : broken);
      }
    }
  }
  CHECK(kept > 1000);
  CHECK(broken > 1000);
}
