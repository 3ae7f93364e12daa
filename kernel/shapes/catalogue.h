// The shapes by name, for the command line and scenes.
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
  double value = 0;  ///< the default
  std::string unit, meaning;
};

struct ShapeInfo {
  std::string name, meaning;
  std::vector<ShapeParameter> parameters;
};

/// All shapes with their parameters, in the order to list them.
const std::vector<ShapeInfo>& shape_catalogue();

/// The shape of that name; parameters not given take their default.
/// \throw InvalidInput for an unknown shape or parameter, listing what there is, and for a value
/// out of its range or not a whole number where one is asked for
Triangles make_shape(const std::string& name, const std::map<std::string, double>& parameters);

}  // namespace suture
