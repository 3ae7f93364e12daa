// Moving, scaling, turning and gathering whole surfaces.
#pragma once

#include <span>

#include "kernel/triangles.h"

namespace suture {

Triangles translated(Triangles surface, const Point& by);

/// Scaled about the origin. \throw InvalidInput unless `factor` is finite and positive: a negative
/// one would turn the surface inside-out
Triangles scaled(Triangles surface, double factor);

/// Scaled about the origin by a factor for each axis. \throw InvalidInput as above, for each
Triangles scaled(Triangles surface, const Point& factors);

/// Turned about the line through the origin along `axis` by `angle` radians, right-handed.
/// \throw InvalidInput unless both are finite and the axis is not zero
Triangles rotated(Triangles surface, const Point& axis, double angle);

/// The surfaces one after another, indices shifted; nothing is welded.
/// \throw InvalidInput if the vertices together outnumber the indices
Triangles merged(std::span<const Triangles> surfaces);

}  // namespace suture
