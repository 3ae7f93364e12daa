// Rows of vertices, and the strips of triangles between them; surfaces of revolution.
#pragma once

#include <functional>
#include <span>

#include "kernel/triangles.h"

namespace suture {

/// Vertices from left to right with a parameter that increases along the row. A closed ring ends
/// with its first vertex once more. A single vertex is a tip.
struct Row {
  std::vector<std::uint32_t> vertices;
  std::vector<double> at;

  void add(std::uint32_t vertex, double where) {
    vertices.push_back(vertex);
    at.push_back(where);
  }
};

/// Triangles of the strip between two rows, counter-clockwise where `upper` lies above `lower`.
/// Vertices are joined to those of like parameter, so the parameters of both should run alike.
void zip(const Row& lower, const Row& upper, std::vector<Triangle>& triangles);

/// A point of the profile that is turned about the z axis, and how many vertices its circle gets.
struct Circle {
  double radius = 0, height = 0;
  int count = 0;  ///< at least 3; where the radius is 0 the circle is one vertex
};

enum class Profile {
  from_axis_to_axis,  ///< rising, first and last radius 0: a sphere's topology
  closed              ///< counter-clockwise in (radius, height), no radius 0: a torus's topology
};

/// The surface of revolution about z, oriented outward. Neighbouring circles are staggered.
Triangles revolved(std::span<const Circle> circles, Profile profile);

/// How many edges of length `edge_length` go round a circle; at least `least`.
int edges_round(double radius, double edge_length, int least = 6);

/// Arc lengths 0 … length in whole steps, each about `step` at where it is taken; both ends are in.
std::vector<double> graded_steps(double length, const std::function<double(double)>& step);

}  // namespace suture
