// Rows of vertices, and the strips of triangles between them; surfaces of revolution.
#pragma once

#include <functional>
#include <span>

#include "kernel/triangles.h"

namespace suture {

/// Vertices from left to right, each with a parameter `at` that increases along the row. A closed
/// ring ends with its first vertex once more. A single vertex is a tip.
struct Row {
  std::vector<std::uint32_t> vertices;
  std::vector<double> at;

  void add(std::uint32_t vertex, double where) {
    vertices.push_back(vertex);
    at.push_back(where);
  }
};

/// Appends the triangles of the strip between two rows, counter-clockwise where `upper` lies above
/// `lower`. Vertices are joined to those of like parameter, so both rows should run through the
/// same parameters. \pre both rows have a vertex
void zip(const Row& lower, const Row& upper, std::vector<Triangle>& triangles);

/// A point of a profile that is turned about the z axis, and the number of vertices of its circle.
struct Circle {
  double radius = 0, height = 0;
  int count = 0;  ///< at least 3; where the radius is 0 the circle is one vertex
};

enum class Profile {
  from_axis_to_axis,  ///< it rises, and the first and last radius are 0: a sphere's topology
  closed  ///< it runs counter-clockwise in (radius, height), and no radius is 0: a torus's topology
};

/// The surface of revolution about z, oriented outward. Neighbouring circles are staggered.
Triangles revolved(std::span<const Circle> circles, Profile profile);

/// The number of edges of about `edge_length` that go round a circle, but at least `least`.
int edges_round(double radius, double edge_length, int least = 6);

/// Arc lengths from 0 to `length`, both included, in steps that are each about step(s) at the arc
/// length s where they are taken. \pre step is positive
std::vector<double> graded_steps(double length, const std::function<double(double)>& step);

}  // namespace suture
