// A start shape as it is meant, not as its mesh has it: smooth faces, creases and its volume.
#pragma once

#include <optional>
#include <vector>

#include "sims/scene/scene.h"

namespace suture::sims {

/// A part of a shape: of a sphere, of a plane, or flat as the mesh has it.
struct ExactFace {
  enum class Kind { sphere, plane, flat } kind = Kind::flat;
  Point at = Point::Zero();  ///< the sphere's centre, or a point of the plane
  Point normal = Point::UnitZ();
  double radius = 0;
};

struct ExactShape {
  Triangles mesh;                   ///< coarse; its vertices lie on the shape
  std::vector<std::uint32_t> face;  ///< of each triangle
  std::vector<ExactFace> faces;
  double volume = 0;  ///< analytic where all faces are exact, else the mesh's
  bool exact = true;  ///< no face is flat for want of a formula
};

/// The scene's bodies at time 0. Spheres and Zalesak's slotted sphere are known exactly, and do not
/// depend on the scene's edge length; other shapes, and all if `polyhedron`, are as their meshes.
struct ExactShapeOptions {
  bool polyhedron = false;
};
ExactShape exact_shape(const Scene& scene, const ExactShapeOptions& options = {});

/// The point between a and b on both faces: pushed out to the sphere, or to the circle where sphere
/// and plane meet; the middle on what is flat. \pre both points are on both faces
Point middle_on(const Point& a, const Point& b, const ExactFace& f, const ExactFace& g);

/// The point of the face that a point near it, as a triangle's centroid, stands for.
Point onto(const Point& p, const ExactFace& face);

/// \return whether the edge between two faces is a crease of the shape
bool is_crease(const ExactFace& f, const ExactFace& g);

}  // namespace suture::sims
