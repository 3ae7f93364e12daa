// Triangulations of polygons whose diagonals may be forbidden [§6.1 steps 4 and 5].
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "kernel/triangles.h"

namespace suture::surgery {

/// Says whether two corners of a polygon, not neighbours on it, may not be joined.
using Forbidden = std::function<bool(std::uint32_t, std::uint32_t)>;

/// Above this many corners a loop is not worth O(n³) time: 64 cost about 45,000 triangle areas.
inline constexpr std::size_t kMostDynamicCorners = 64;

/// The triangulation of a closed loop in space with the least area, by dynamic programming;
/// triangles index `loop` and follow its direction. Nothing where every triangulation needs a
/// forbidden diagonal. \pre 3 <= loop.size() <= kMostDynamicCorners
std::optional<std::vector<Triangle>> least_area(std::span<const Point> loop,
                                                const Forbidden& forbidden);

/// A region of a plane: its corners, and its boundary as loops of corners, each with the region on
/// its left (outer loops counter-clockwise, holes clockwise). A corner may stand in several loops.
struct PlanarRegion {
  std::vector<Point> corners;  ///< in space
  std::vector<std::vector<std::uint32_t>> loops;
  Point normal;  ///< of the plane, any length; corners are seen along its longest axis
};

/// Triangles that cover the region and have it on their left, all turned the same way by an exact
/// test of the corners' doubles. Nothing where rounding has folded the region or a diagonal is
/// forbidden.
std::optional<std::vector<Triangle>> triangulate_planar(const PlanarRegion& region,
                                                        const Forbidden& forbidden);

}  // namespace suture::surgery
