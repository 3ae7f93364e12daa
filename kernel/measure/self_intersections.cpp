// CGAL's box intersection finds the candidates, its exact predicates decide. The rules for shared
// vertices are those of Polygon_mesh_processing, which itself takes manifold meshes only.
#include "kernel/measure/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace suture {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

// The number of boxes below which CGAL compares all pairs; its own users have this value.
constexpr std::ptrdiff_t kCutoff = 2000;

/// The callback throws it, as CGAL's search has no other way to end early.
struct Enough {};

struct Face {
  Triangle index;
  std::array<Vertex, 3> at;
  Kernel::Triangle_3 triangle() const { return {at[0], at[1], at[2]}; }
};

bool holds(const Triangle& t, std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

// A face seen from one of its corners.
struct FaceCorner {
  const Face& face;
  std::size_t k;

  const Vertex& at() const { return face.at[k]; }
  const Vertex& next() const { return face.at[(k + 1) % 3]; }
  const Vertex& prev() const { return face.at[(k + 2) % 3]; }
  Kernel::Segment_3 opposite() const { return {next(), prev()}; }
};

// The first corner of `a` whose vertex is in `b` too. There must be one.
FaceCorner first_shared(const Face& a, const Face& b) {
  std::size_t k = 0;
  while (!holds(b.index, a.index[k])) ++k;
  return {a, k};
}

// The first corner of `a` whose vertex is not in `b`. There must be one.
FaceCorner first_own(const Face& a, const Face& b) {
  std::size_t k = 0;
  while (holds(b.index, a.index[k])) ++k;
  return {a, k};
}

// Faces that share the edge opposite to these corners overlap if they are folded flat, on one side.
bool meet_beyond_edge(const FaceCorner& a, const FaceCorner& b) {
  const Vertex &p = a.next(), &q = a.prev();
  return CGAL::coplanar(p, q, a.at(), b.at()) &&
         CGAL::coplanar_orientation(p, q, a.at(), b.at()) == CGAL::POSITIVE;
}

// Faces that share the vertex of these corners meet elsewhere if the side of one that is opposite
// to it reaches the other.
bool meet_beyond_vertex(const FaceCorner& a, const FaceCorner& b) {
  return CGAL::do_intersect(a.face.triangle(), b.opposite()) ||
         CGAL::do_intersect(b.face.triangle(), a.opposite());
}

bool meet(const Face& a, const Face& b) {
  const auto shared = std::count_if(a.index.begin(), a.index.end(),
                                    [&](std::uint32_t v) { return holds(b.index, v); });
  switch (shared) {
    case 0:
      return CGAL::do_intersect(a.triangle(), b.triangle());
    case 1:
      return meet_beyond_vertex(first_shared(a, b), first_shared(b, a));
    case 2:
      return meet_beyond_edge(first_own(a, b), first_own(b, a));
    default:
      return true;
  }
}

}  // namespace

SelfIntersections self_intersections(const Triangles& surface,
                                     const SelfIntersectionOptions& options) {
  SelfIntersections result;
  std::vector<Face> faces(surface.triangles.size());
  std::vector<Box> boxes;
  boxes.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Face& face = faces[i];
    face.index = surface.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = surface.positions[face.index[k]];
      face.at[k] = Vertex(p[0], p[1], p[2]);
    }
    if (CGAL::collinear(face.at[0], face.at[1], face.at[2]))
      ++result.without_area;
    else
      boxes.emplace_back(face.triangle().bbox(), static_cast<std::uint32_t>(i));
  }
  const auto report = [&](const Box& a, const Box& b) {
    if (!meet(faces[a.info()], faces[b.info()])) return;
    if (result.pairs.size() >= options.most) throw Enough{};
    result.pairs.push_back(std::minmax(a.info(), b.info()));
  };
  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), report, kCutoff);
  } catch (const Enough&) {
    result.capped = true;
  }
  std::sort(result.pairs.begin(), result.pairs.end());
  return result;
}

}  // namespace suture
