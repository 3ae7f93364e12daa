// The shapes by name, with their parameters, for programs that let users choose.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kernel/triangles.h"

namespace suture {

/// One number that a shape takes. Its unit is "length" (the scene's), "radius" or "body length"
/// (a part of the shape's own), "degrees", or "whole number".
struct ShapeParameter {
  std::string name;
  double value = 0;  ///< its default
  std::string unit, meaning;
};

/// A shape's name and meaning, and the numbers that it takes.
struct ShapeInfo {
  std::string name, meaning;
  std::vector<ShapeParameter> parameters;
};

/// All shapes with their parameters, in the order in which to list them.
const std::vector<ShapeInfo>& shape_catalogue();

/// Makes the shape of that name; parameters that are not given take their defaults.
/// \throw InvalidInput for an unknown shape or parameter, with a list of those that there are, and
/// for a value that is out of its range, or no whole number where one is asked for
Triangles make_shape(const std::string& name, const std::map<std::string, double>& parameters);

}  // namespace suture
