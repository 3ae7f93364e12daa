#include "surgery/collapse/straighten.h"

#include <catch2/catch.hpp>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "surgery/quality/passes.h"
#include "tests/surgery/quality_bodies.h"

using namespace suture;
using namespace suture::surgery;
using namespace suture::bodies;

namespace {

using Vertex = Mesh::Vertex_index;

/// A body whose edges across z = height are split there, as a cut would; of the new vertices each
/// `stride`-th is taken for type 1, the others for type 2.
struct CutBody {
  Mesh mesh;
  std::vector<Vertex> type1, type2;
};

CutBody cut(const Triangles& s, const std::vector<double>& heights, std::size_t stride) {
  CutBody body{to_mesh(s), {}, {}};
  Mesh& mesh = body.mesh;
  for (const double height : heights) {
    std::vector<Mesh::Edge_index> across;
    for (const auto e : mesh.edges())
      if ((mesh.point(mesh.vertex(e, 0)).z() - height) *
              (mesh.point(mesh.vertex(e, 1)).z() - height) <
          0)
        across.push_back(e);
    for (const auto e : across) {
      const auto h = mesh.halfedge(e);
      const Point a = to_point(mesh.point(mesh.source(h)));
      const Point b = to_point(mesh.point(mesh.target(h)));
      Point at = a + (b - a) * ((height - a[2]) / (b[2] - a[2]));
      at[2] = height;
      const auto v = split_edge(mesh, h, at);
      (body.type1.size() * stride <= body.type2.size() ? body.type1 : body.type2).push_back(v);
    }
  }
  return body;
}

}  // namespace

TEST_CASE("type 2 vertices go, type 1 vertices stay, and the surface stays a closed manifold") {
  for (const double height : {0.01, 0.3, -0.77}) {
    CutBody body = cut(ball(4), {height}, 5);
    REQUIRE(body.type2.size() > 50);
    const auto counts = straighten(body.mesh, {body.type1, body.type2, {}}, {});
    CHECK(counts.done * 20 > 17 * body.type2.size());
    CHECK(counts.done + counts.refused_normal == body.type2.size());
    for (const auto v : body.type1) {
      CHECK_FALSE(body.mesh.is_removed(v));
      CHECK(body.mesh.point(v).z() == height);
    }
    CHECK(audit(to_triangles(body.mesh)).closed_manifold());
    CHECK(volume(to_triangles(body.mesh)) == Approx(volume(ball(4))).epsilon(0.002));
  }
}

TEST_CASE("a type 2 vertex that no rule lets go stays and is counted once") {
  CutBody body = cut(ball(3), {0.1}, 5);
  const auto counts = straighten(body.mesh, {body.type1, body.type2, {}},
                                 {.cos_turn = std::cos(0.01), .volume_bound = 1e-6});
  std::size_t left = 0;
  for (const auto v : body.type2) left += !body.mesh.is_removed(v);
  CHECK(left > 0);
  CHECK(counts.done == body.type2.size() - left);
  CHECK(counts.refused_link + counts.refused_normal + counts.refused_node + counts.refused_volume +
            counts.refused_feature + counts.delayed ==
        left);
}

TEST_CASE("a type 2 vertex with no neighbour of either type is counted as delayed") {
  Mesh mesh = to_mesh(ball(2));
  const auto counts = straighten(mesh, {{}, {Vertex(0)}, {}}, {});
  CHECK(counts.done == 0);
  CHECK(counts.delayed == 1);
  CHECK_FALSE(mesh.has_garbage());
}

TEST_CASE("straightening twice from the same mesh gives the same bits") {
  CutBody a = cut(ball(4), {0.3}, 7), b = cut(ball(4), {0.3}, 7);
  straighten(a.mesh, {a.type1, a.type2, {}}, {});
  straighten(b.mesh, {b.type1, b.type2, {}}, {});
  CHECK(to_triangles(a.mesh) == to_triangles(b.mesh));
}

TEST_CASE("straightening slivers, needles and coincident vertices keeps a closed manifold") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Dice dice(seed);
    CutBody body = cut(tormented(ball(3), dice, 0.2), {0.05}, 1 + dice.below(6));
    const auto counts =
        straighten(body.mesh, {body.type1, body.type2, {}}, {.sliver_height = 1e-4});
    REQUIRE(audit(to_triangles(body.mesh)).closed_manifold());
    CHECK(counts.done * 2 > body.type2.size());
  }
}

TEST_CASE("ten thousand type 2 vertices are straightened in their turn") {
  std::vector<double> heights;
  for (int i = -20; i <= 20; ++i) heights.push_back(0.0477 * i + 0.001);
  CutBody body = cut(ball(5), heights, 5);
  const auto counts = straighten(body.mesh, {body.type1, body.type2, {}}, {});
  CHECK(counts.done * 10 > 9 * body.type2.size());
  CHECK(audit(to_triangles(body.mesh)).closed_manifold());
}
