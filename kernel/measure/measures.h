// Volume, area, edge lengths, angles and components of a surface.
#pragma once

#include <cstdint>

#include "kernel/triangles.h"

namespace suture {

// All of them take surfaces that may be open or non-manifold. \pre indices in range

/// The signed volume, in cubes of the scene's unit: the sum over tetrahedra to the centre of the
/// bounding box, in extended precision. It means something for closed surfaces only.
double volume(const Triangles& surface);

/// The area, in squares of the scene's unit.
double area(const Triangles& surface);

/// The Euler characteristic V − E + F, over the vertices that are in a triangle.
std::int64_t euler_characteristic(const Triangles& surface);

/// The component of each triangle, numbered in the order of their first triangles. Triangles belong
/// together where they share a vertex.
struct Components {
  std::vector<std::uint32_t> of_triangle;
  std::size_t count = 0;
};
Components components(const Triangles& surface);

/// Lengths of edges in the scene's unit; the mean counts each edge once. All are 0 without edges.
struct EdgeLengths {
  double shortest = 0, mean = 0, longest = 0;
};
EdgeLengths edge_lengths(const Triangles& surface);

/// The smallest and largest angle of any triangle, in degrees: 0 and 180 where a triangle has no
/// area, and both 0 without triangles.
struct Angles {
  double smallest = 0, largest = 0;
};
Angles angles(const Triangles& surface);

}  // namespace suture
