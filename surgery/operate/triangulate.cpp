// Small loops by dynamic programming, larger planar regions by CGAL's constrained Delaunay.
#include "surgery/operate/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace suture::surgery {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<char, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                            CGAL::No_constraint_intersection_tag>;

constexpr double kImpossible = std::numeric_limits<double>::infinity();

/// The triangulation of a polygon of n corners with the least sum of weight(i, j, k).
template <class Weight>
std::optional<std::vector<Triangle>> least_weight(std::uint32_t n, const Forbidden& forbidden,
                                                  Weight weight) {
  std::vector<double> cost(std::size_t{n} * n, kImpossible);
  std::vector<std::uint32_t> apex(std::size_t{n} * n, 0);
  for (std::uint32_t i = 0; i + 1 < n; ++i) cost[i * n + i + 1] = 0;
  for (std::uint32_t width = 2; width < n; ++width)
    for (std::uint32_t i = 0; i + width < n; ++i) {
      const std::uint32_t j = i + width;
      if (width < n - 1 && forbidden(i, j)) continue;
      for (std::uint32_t k = i + 1; k < j; ++k) {
        const double sides = cost[i * n + k] + cost[k * n + j];
        if (!(sides < cost[i * n + j])) continue;
        const double total = sides + weight(i, k, j);
        if (!(total < cost[i * n + j])) continue;
        cost[i * n + j] = total;
        apex[i * n + j] = k;
      }
    }
  if (cost[n - 1] == kImpossible) return std::nullopt;
  std::vector<Triangle> triangles;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open = {{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j < i + 2) continue;
    const std::uint32_t k = apex[i * n + j];
    triangles.push_back({i, k, j});
    open.emplace_back(i, k);
    open.emplace_back(k, j);
  }
  return triangles;
}

/// Differences to the first point in units of a power of two near their extent: exact, and weights
/// of them neither overflow nor vanish at any scale.
std::vector<Point> normalised(std::span<const Point> points) {
  double extent = 0;
  for (const Point& p : points)
    extent = std::max(extent, (p / 4 - points.front() / 4).cwiseAbs().maxCoeff());
  const double unit =
      extent > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(extent), -1000, 1000)) : 1;
  std::vector<Point> result;
  for (const Point& p : points) result.push_back((p / 4 - points.front() / 4) * unit);
  return result;
}

/// The corners as seen along the normal's longest axis, so that the region is on the left of its
/// boundary.
std::vector<Kernel::Point_2> flattened(const PlanarRegion& region) {
  Eigen::Index drop = 0;
  region.normal.cwiseAbs().maxCoeff(&drop);
  const auto u = (drop + 1) % 3, v = (drop + 2) % 3;
  const bool flip = region.normal[drop] < 0;
  std::vector<Kernel::Point_2> flat;
  flat.reserve(region.corners.size());
  for (const Point& p : region.corners) flat.emplace_back(flip ? p[v] : p[u], flip ? p[u] : p[v]);
  return flat;
}

/// Triangulates a single loop without repeated corners: least sum of squared edges, no triangle
/// turned right. Corners that share a line or a place, as a mesh aligned with the lattice has them,
/// give some without area.
std::optional<std::vector<Triangle>> triangulate_simple(const PlanarRegion& region,
                                                        const std::vector<Kernel::Point_2>& flat,
                                                        const Forbidden& forbidden) {
  const std::vector<std::uint32_t>& loop = region.loops.front();
  if (loop.size() == 3) {  // every second one
    if (CGAL::orientation(flat[loop[0]], flat[loop[1]], flat[loop[2]]) == CGAL::RIGHT_TURN)
      return std::nullopt;
    return std::vector<Triangle>{{loop[0], loop[1], loop[2]}};
  }
  const std::vector<Point> corners = normalised(region.corners);
  auto found = least_weight(
      static_cast<std::uint32_t>(loop.size()),
      [&](std::uint32_t i, std::uint32_t j) { return forbidden(loop[i], loop[j]); },
      [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        if (CGAL::orientation(flat[loop[i]], flat[loop[j]], flat[loop[k]]) == CGAL::RIGHT_TURN)
          return kImpossible;
        const Point &a = corners[loop[i]], &b = corners[loop[j]], &c = corners[loop[k]];
        return (a - b).squaredNorm() + (b - c).squaredNorm() + (c - a).squaredNorm();
      });
  if (found)
    for (Triangle& t : *found) t = {loop[t[0]], loop[t[1]], loop[t[2]]};
  return found;
}

/// A triangulation, and its vertex for each corner of the region.
struct NumberedDelaunay {
  Delaunay delaunay;
  std::vector<Delaunay::Vertex_handle> handle;
};

/// Marks the faces on the left of the boundary. \return nothing where a boundary edge was split or
/// is missing
std::optional<std::vector<Triangle>> left_faces(const NumberedDelaunay& numbered,
                                                const PlanarRegion& region,
                                                const Forbidden& forbidden) {
  const auto& [delaunay, handle] = numbered;
  std::vector<Delaunay::Face_handle> open;
  std::set<std::pair<std::uint32_t, std::uint32_t>> boundary;
  for (const auto& loop : region.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t from = loop[i], to = loop[(i + 1) % loop.size()];
      Delaunay::Face_handle face;
      int side = 0;  // is_edge gives the face on the left of from → to
      if (!delaunay.is_edge(handle[from], handle[to], face, side)) return std::nullopt;
      if (face->vertex(Delaunay::ccw(side)) == handle[to]) face = face->neighbor(side);
      if (!boundary.emplace(from, to).second || delaunay.is_infinite(face)) return std::nullopt;
      open.push_back(face);
    }
  std::vector<Triangle> triangles;
  while (!open.empty()) {
    const Delaunay::Face_handle face = open.back();
    open.pop_back();
    if (face->info() == 1) continue;
    face->info() = 1;
    if (delaunay.is_infinite(face)) return std::nullopt;
    Triangle t;
    for (int k = 0; k < 3; ++k) t[k] = face->vertex(k)->info();
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = t[Delaunay::ccw(k)], to = t[Delaunay::cw(k)];
      if (boundary.contains({from, to})) continue;
      if (boundary.contains({to, from}) || forbidden(from, to)) return std::nullopt;
      open.push_back(face->neighbor(k));
    }
    triangles.push_back(t);
  }
  return triangles;
}

std::optional<std::vector<Triangle>> triangulate_general(const PlanarRegion& region,
                                                         const std::vector<Kernel::Point_2>& flat,
                                                         const Forbidden& forbidden) {
  NumberedDelaunay numbered;
  auto& [delaunay, handle] = numbered;
  handle.resize(flat.size());
  for (std::uint32_t i = 0; i < flat.size(); ++i) {
    const std::size_t before = delaunay.number_of_vertices();
    handle[i] = delaunay.insert(flat[i]);
    if (delaunay.number_of_vertices() == before) return std::nullopt;  // two sites, one double
    handle[i]->info() = i;
  }
  try {
    for (const auto& loop : region.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        delaunay.insert_constraint(handle[loop[i]], handle[loop[(i + 1) % loop.size()]]);
  } catch (const Delaunay::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  for (const auto face : delaunay.all_face_handles()) face->info() = 0;
  return left_faces(numbered, region, forbidden);
}

}  // namespace

std::optional<std::vector<Triangle>> least_area(std::span<const Point> loop,
                                                const Forbidden& forbidden) {
  const std::vector<Point> p = normalised(loop);
  return least_weight(static_cast<std::uint32_t>(p.size()), forbidden,
                      [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
                        return (p[j] - p[i]).cross(p[k] - p[i]).norm();
                      });
}

std::optional<std::vector<Triangle>> triangulate_planar(const PlanarRegion& region,
                                                        const Forbidden& forbidden) {
  const std::vector<Kernel::Point_2> flat = flattened(region);
  const std::size_t corners = region.corners.size();
  const bool simple = region.loops.size() == 1 && region.loops.front().size() == corners;
  if (simple && corners <= kMostDynamicCorners) return triangulate_simple(region, flat, forbidden);
  auto found = triangulate_general(region, flat, forbidden);
  // A constraint that runs through a corner is beyond Delaunay; slow programming is better than a
  // split.
  constexpr std::size_t kMostSlowCorners = 400;
  if (!found && simple && corners <= kMostSlowCorners)
    found = triangulate_simple(region, flat, forbidden);
  return found;
}

}  // namespace suture::surgery
