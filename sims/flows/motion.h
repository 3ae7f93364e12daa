// A prescribed motion: a velocity field, or new positions that the surface itself decides.
#pragma once

#include <memory>

#include "sims/tracking/simulator.h"

namespace suture::sims {

/// Moves a surface as it is told, and lets any step be as long as it is asked for.
class Motion : public Simulator {
 public:
  /// The velocity field that it is, which carries any points the same way; null if it is none.
  virtual const VelocityField* field() const { return nullptr; }

  /// Where the surface's vertices are after dt; the motion's own state goes on by dt too.
  /// \pre field() is null
  virtual std::vector<Point> positions(const Triangles& surface, double dt) = 0;

  void step(SurfaceTracker& surface, double dt) override { advance(surface, dt); }

  /// As step, for a SurfaceTracker or a bare Tracker.
  template <class AnyTracker>
  void advance(AnyTracker& tracker, double dt) {
    if (const VelocityField* u = field())
      tracker.advect(*u, dt);
    else
      tracker.displace(positions(tracker.surface(), dt), dt);
  }
};

}  // namespace suture::sims
