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

constexpr std::ptrdiff_t kCutoff =
    2000;  // boxes below which CGAL compares all; its own users' value

/// Thrown by the callback, as CGAL's search has no other way to end early.
struct Enough {};

struct Face {
  Triangle index;
  std::array<Vertex, 3> at;
  Kernel::Triangle_3 triangle() const { return {at[0], at[1], at[2]}; }
};

bool holds(const Triangle& t, std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

// The place in `a` of its first vertex that is (or, with `shared` off, is not) also in `b`.
std::size_t first_where(const Face& a, const Face& b, bool shared) {
  std::size_t i = 0;
  while (holds(b.index, a.index[i]) != shared) ++i;
  return i;
}

// Sharing the edge opposite to vertex i of a and j of b: they overlap if folded flat, on one side.
bool meet_beyond_edge(const Face& a, std::size_t i, const Face& b, std::size_t j) {
  const Vertex &p = a.at[(i + 1) % 3], &q = a.at[(i + 2) % 3];
  return CGAL::coplanar(p, q, a.at[i], b.at[j]) &&
         CGAL::coplanar_orientation(p, q, a.at[i], b.at[j]) == CGAL::POSITIVE;
}

// Sharing vertex i of a and j of b: they meet elsewhere if an opposite side reaches the other.
bool meet_beyond_vertex(const Face& a, std::size_t i, const Face& b, std::size_t j) {
  const Kernel::Segment_3 opposite_a(a.at[(i + 1) % 3], a.at[(i + 2) % 3]);
  const Kernel::Segment_3 opposite_b(b.at[(j + 1) % 3], b.at[(j + 2) % 3]);
  return CGAL::do_intersect(a.triangle(), opposite_b) ||
         CGAL::do_intersect(b.triangle(), opposite_a);
}

bool meet(const Face& a, const Face& b) {
  const auto shared = std::count_if(a.index.begin(), a.index.end(),
                                    [&](std::uint32_t v) { return holds(b.index, v); });
  switch (shared) {
    case 0:
      return CGAL::do_intersect(a.triangle(), b.triangle());
    case 1:
      return meet_beyond_vertex(a, first_where(a, b, true), b, first_where(b, a, true));
    case 2:
      return meet_beyond_edge(a, first_where(a, b, false), b, first_where(b, a, false));
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
