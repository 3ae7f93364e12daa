// A solid as a scene describes it.
#pragma once

#include "kernel/triangles.h"
#include "sims/fluid/solids/solids.h"

namespace suture::sims {

enum class SolidKind { container, box, ball, mesh };

struct SolidOptions {
  SolidKind kind = SolidKind::container;
  Box box;                       ///< of a container, its inside; of a box
  Point centre = Point::Zero();  ///< of a ball
  double radius = 0;
  Triangles surface;  ///< of a mesh
  SolidMotion motion;
};

/// `frame`: of the physics grid, which a mesh is seen by. \throw InvalidInput as Solid's makers
inline Solid make_solid(const SolidOptions& s, const GridFrame& frame) {
  switch (s.kind) {
    case SolidKind::box:
      return Solid::box(s.box, s.motion);
    case SolidKind::ball:
      return Solid::ball(s.centre, s.radius, s.motion);
    case SolidKind::mesh:
      return Solid::mesh(s.surface, frame, s.motion);
    case SolidKind::container:
      break;
  }
  return Solid::container(s.box, s.motion);
}

}  // namespace suture::sims
