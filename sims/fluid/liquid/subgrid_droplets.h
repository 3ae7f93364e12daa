// Droplets without a cell's centre: no pressure carries them, so at a solid they move as one.
#pragma once

#include <vector>

#include "sims/fluid/liquid/liquid.h"
#include "sims/fluid/solids/wall_projection.h"

namespace suture::sims {

/// The droplets at a solid in a step, and where they go. All others fly with the velocity that the
/// liquid's faces have at each of their vertices, which at a solid would flatten them.
class DropletsAtSolids {
 public:
  /// Finds which of `droplets`, of `surface`, come near a solid on their way from walls.t on for
  /// walls.dt. Each goes on with the mean of its vertices' velocities, projected: it lands and
  /// lies, or slides without friction. The known faces of its cells, but for those of other liquid,
  /// hold that velocity from here on. One that solids leave no way is squeezed, vertex by vertex.
  /// \pre `velocity` is known at the droplets' faces, as project leaves it
  DropletsAtSolids(const std::vector<SubgridDroplet>& droplets, const Triangles& surface,
                   const WallProjection& walls, const Liquid& liquid, MacVelocity& velocity);

  bool any() const { return !moved_.empty(); }
  /// Puts their vertices where they go. \pre as many positions as the surface had
  void put(std::vector<Point>& positions) const;

 private:
  struct Vertex {
    std::uint32_t index;
    Point to;
  };
  std::vector<Vertex> moved_;
};

}  // namespace suture::sims
