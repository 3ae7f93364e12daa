// Moving, scaling, turning and gathering whole surfaces.
#pragma once

#include <span>

#include "kernel/triangles.h"

namespace suture {

/// The surface moved by `by`. \throw InvalidInput unless that is finite
Triangles translated(Triangles surface, const Point& by);

/// The surface scaled about the origin. \throw InvalidInput unless `factor` is finite and positive:
/// a negative one would turn the surface inside-out
Triangles scaled(Triangles surface, double factor);

/// The surface scaled about the origin by a factor for each axis. \throw InvalidInput unless each
/// is finite and positive
Triangles scaled(Triangles surface, const Point& factors);

/// The surface turned about the line through the origin along `axis` by `angle` radians,
/// right-handed.
/// \throw InvalidInput unless both are finite and the axis is not zero
Triangles rotated(Triangles surface, const Point& axis, double angle);

/// The surfaces one after another, with their indices shifted; nothing is welded.
/// \throw InvalidInput if the vertices together outnumber the indices
Triangles merged(std::span<const Triangles> surfaces);

}  // namespace suture
