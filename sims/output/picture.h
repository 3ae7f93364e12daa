// What a picture of a surface shows, and how: free of the renderer.
#pragma once

#include <filesystem>
#include <optional>

#include "kernel/lattice.h"
#include "kernel/triangles.h"

namespace suture::sims {

/// The meaning of a triangle's colour.
enum class Colour {
  plain,      ///< one colour
  patches,    ///< what surgery made, fading with age
  components  ///< connected components
};

/// A plane; what lies on the side that the normal points to is cut away.
struct CutPlane {
  Point point = Point::Zero(), normal = Point::UnitY();
};

struct PictureOptions {
  int width = 1280, height = 960;               ///< pixels
  Point direction = Point(-0.55, 0.75, -0.38);  ///< the way the camera looks
  Point up = Point::UnitZ();
  double view_angle = 26;  ///< degrees from bottom to top
  double zoom = 1;         ///< above 1: closer than what fits everything
  std::optional<Box> fit;  ///< the camera shows this box; else the surface
  std::optional<CutPlane> cut;
  bool edges = false;         ///< draw triangle edges
  double feature_angle = 40;  ///< degrees between normals; sharper edges are drawn sharp
};

/// A colour a triangle, red, green and blue from 0 to 1; empty for the plain one.
using TriangleColours = std::vector<Eigen::Vector3f>;

}  // namespace suture::sims
