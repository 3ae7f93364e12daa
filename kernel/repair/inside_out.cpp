// Inside-out components are found by the exact signs of volumes and by how components are nested.
#include "kernel/repair/inside_out.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>

#include "kernel/corners.h"
#include "kernel/lattice.h"
#include "kernel/lists.h"
#include "kernel/measure/measures.h"
#include "kernel/mesh.h"

namespace suture {

namespace {

using SideOf = CGAL::Side_of_triangle_mesh<Mesh, CgalKernel>;

struct Component {
  std::vector<std::uint32_t> triangles;
  int sign = 0;  // the sign of its volume
  Box box;
  std::array<Point, 6> extremes;  // the vertices lowest and highest on each axis
  std::unique_ptr<Mesh> mesh;     // made when first asked for
  std::unique_ptr<SideOf> side;
};

int exact_volume_sign(const Triangles& surface, const Component& part) {
  using Number = CGAL::Exact_rational;
  const Point& origin = surface.positions[surface.triangles[part.triangles[0]][0]];
  const auto from_origin = [&](std::uint32_t v) {
    const Point& p = surface.positions[v];
    return std::array<Number, 3>{Number(p[0]) - Number(origin[0]), Number(p[1]) - Number(origin[1]),
                                 Number(p[2]) - Number(origin[2])};
  };
  Number sum = 0;
  for (const std::uint32_t i : part.triangles) {
    const Triangle& t = surface.triangles[i];
    const auto a = from_origin(t[0]), b = from_origin(t[1]), c = from_origin(t[2]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return CGAL::sign(sum);
}

int volume_sign(const Triangles& surface, const Component& part) {
  using Wide = Eigen::Matrix<long double, 3, 1>;
  const Wide origin =
      surface.positions[surface.triangles[part.triangles[0]][0]].cast<long double>();
  long double sum = 0, size = 0;
  for (const std::uint32_t i : part.triangles) {
    const Triangle& t = surface.triangles[i];
    const Wide a = surface.positions[t[0]].cast<long double>() - origin;
    const Wide b = surface.positions[t[1]].cast<long double>() - origin;
    const Wide c = surface.positions[t[2]].cast<long double>() - origin;
    sum += a.dot(b.cross(c));
    size += a.cwiseAbs().sum() * b.cwiseAbs().sum() * c.cwiseAbs().sum();
  }
  // Each term is off by under 16 roundings of 2^-64 of its size, each addition by one.
  const long double bound =
      std::ldexp(static_cast<long double>(part.triangles.size() + 16), -63) * size;
  if (sum > bound) return 1;
  if (sum < -bound) return -1;
  return exact_volume_sign(surface, part);
}

// A component has 1 if every edge of it is used once each way, else 0.
std::vector<std::uint8_t> closed_components(const Triangles& surface, const Components& parts) {
  const Corners corners(surface);
  std::vector<std::uint8_t> closed(parts.count, 1);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    std::uint8_t& good = closed[parts.of_triangle[i]];
    if (!usable(t, surface.positions.size())) good = 0;
    for (std::size_t k = 0; k < 3 && good != 0; ++k) {
      int out = 0, in = 0;
      corners.for_each_use(t[k], t[(k + 1) % 3],
                           [&](std::uint32_t, bool along) { ++(along ? out : in); });
      good = out == 1 && in == 1;
    }
  }
  return closed;
}

void measure(const Triangles& surface, Component& part) {
  part.sign = volume_sign(surface, part);
  part.extremes.fill(surface.positions[surface.triangles[part.triangles[0]][0]]);
  for (const std::uint32_t i : part.triangles)
    for (const std::uint32_t v : surface.triangles[i]) {
      const Point& p = surface.positions[v];
      for (int axis = 0; axis < 3; ++axis) {
        Point &low = part.extremes[2 * axis], &high = part.extremes[2 * axis + 1];
        if (p[axis] < low[axis]) low = p;
        if (p[axis] > high[axis]) high = p;
      }
    }
  for (int axis = 0; axis < 3; ++axis) {
    part.box.low[axis] = part.extremes[2 * axis][axis];
    part.box.high[axis] = part.extremes[2 * axis + 1][axis];
  }
}

std::vector<Component> split(const Triangles& surface) {
  const Components parts = components(surface);
  const std::vector<std::uint8_t> closed = closed_components(surface, parts);
  std::vector<Component> all(parts.count);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    all[parts.of_triangle[i]].triangles.push_back(static_cast<std::uint32_t>(i));
  std::vector<Component> result;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (closed[i] != 0) {
      measure(surface, all[i]);
      result.push_back(std::move(all[i]));
    }
  return result;
}

bool box_inside(const Box& inner, const Box& outer) {
  return (inner.low.array() > outer.low.array()).all() &&
         (inner.high.array() < outer.high.array()).all();
}

// A copy of the component with its own vertices only, so that many components take no more memory
// than one.
Triangles alone(const Triangles& surface, const Component& part) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t i : part.triangles)
    vertices.insert(vertices.end(), surface.triangles[i].begin(), surface.triangles[i].end());
  sort_unique(vertices);
  Triangles result;
  for (const std::uint32_t v : vertices) result.positions.push_back(surface.positions[v]);
  for (const std::uint32_t i : part.triangles) {
    Triangle t = surface.triangles[i];
    for (std::uint32_t& v : t)
      v = static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                                     vertices.begin());
    result.triangles.push_back(t);
  }
  return result;
}

// Whether `inner` lies within `outer`.
bool inside(const Triangles& surface, const Component& inner, Component& outer) {
  if (!box_inside(inner.box, outer.box)) return false;
  if (!outer.side) {
    outer.mesh = std::make_unique<Mesh>(to_mesh(alone(surface, outer)));
    outer.side = std::make_unique<SideOf>(*outer.mesh);
  }
  return std::all_of(inner.extremes.begin(), inner.extremes.end(), [&](const Point& p) {
    return (*outer.side)(to_cgal(p)) == CGAL::ON_BOUNDED_SIDE;
  });
}

}  // namespace

std::vector<std::uint32_t> inside_out_components(const Triangles& surface) {
  std::vector<Component> parts = split(surface);
  const bool none =
      std::all_of(parts.begin(), parts.end(), [](const Component& c) { return c.sign >= 0; });
  if (none) return {};
  std::vector<std::vector<std::size_t>> round(parts.size());  // the components round each
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < parts.size(); ++j)
      if (i != j && inside(surface, parts[i], parts[j])) round[i].push_back(j);
  std::vector<std::size_t> order = identity_map<std::size_t>(parts.size());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return round[a].size() < round[b].size(); });
  std::vector<std::uint8_t> wrong(parts.size(), 0);
  std::vector<std::uint32_t> result;
  for (const std::size_t i : order) {
    int winding = 0;
    std::size_t parent = i;  // the component straight round it: the one deepest itself
    for (const std::size_t j : round[i]) {
      winding += wrong[j] != 0 ? -parts[j].sign : parts[j].sign;
      if (parent == i || round[j].size() > round[parent].size()) parent = j;
    }
    const bool in_nothing = parts[i].sign < 0 && winding < 1;
    const bool was_cavity = parts[i].sign > 0 && parent != i && wrong[parent] != 0 && winding == 1;
    wrong[i] = in_nothing || was_cavity ? 1 : 0;
    if (wrong[i] != 0) result.push_back(parts[i].triangles[0]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

void turn_components(Triangles& surface, const std::vector<std::uint32_t>& triangles) {
  const Components parts = components(surface);
  std::vector<std::uint8_t> turn(parts.count, 0);
  for (const std::uint32_t t : triangles) turn[parts.of_triangle[t]] = 1;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    if (turn[parts.of_triangle[i]] != 0)
      std::swap(surface.triangles[i][1], surface.triangles[i][2]);
}

}  // namespace suture
