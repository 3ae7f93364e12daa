// A body by what it was made from: for whoever needs its exact shape and not only its mesh.
#pragma once

#include <map>
#include <string>

#include "kernel/triangles.h"

namespace suture::sims {

/// A shape of the catalogue, scaled, turned and moved, or a mesh of its own; in a scene's surface
/// it has `vertices` and `triangles` of these, after those of the bodies before it.
struct PlacedShape {
  std::string shape;  ///< empty: a mesh file, or one that was normalised or repaired
  std::map<std::string, double> parameters;
  double scale = 1;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Point move = Point::Zero();
  std::size_t vertices = 0, triangles = 0;
};

}  // namespace suture::sims
