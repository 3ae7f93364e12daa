// Volume, area, angles, components and distances of a surface. No paper here.
#pragma once

#include <cstdint>

#include "kernel/triangles.h"

namespace suture {

/// Signed volume by the tetrahedral sum in extended precision, about the centre of the bounding
/// box.
double volume(const Triangles& surface);
double area(const Triangles& surface);

/// V − E + F over the vertices that are in a triangle.
std::int64_t euler_characteristic(const Triangles& surface);

/// Component of each triangle (joined through shared vertices), numbered in order of first
/// appearance.
struct Components {
  std::vector<std::uint32_t> of_triangle;
  std::size_t count = 0;
};
Components components(const Triangles& surface);

struct EdgeLengths {
  double shortest = 0, mean = 0, longest = 0;
};
EdgeLengths edge_lengths(const Triangles& surface);

/// Smallest and largest angle of any triangle, in degrees; 0 and 180 for a triangle without area.
struct Angles {
  double smallest = 0, largest = 0;
};
Angles angles(const Triangles& surface);

}  // namespace suture
