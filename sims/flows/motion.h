// A prescribed motion: a velocity field, or new positions that the surface itself decides.
#pragma once

#include <memory>

#include "sims/tracking/simulator.h"

namespace suture::sims {

/// A simulator that is known beforehand, and takes steps of any length.
class Motion : public Simulator {
 public:
  /// The motion as a velocity field, which carries any points the same way; null if it is none.
  virtual const VelocityField* field() const { return nullptr; }

  /// New places of the surface's vertices after dt; the motion's own state goes on by dt too.
  /// \pre field() is null
  virtual std::vector<Point> positions(const Triangles& surface, double dt) = 0;

  void step(SurfaceTracker& surface, double dt) override { advance(surface, dt); }

  /// Does the same as step to a SurfaceTracker or a bare Tracker.
  template <class AnyTracker>
  void advance(AnyTracker& tracker, double dt) {
    if (const VelocityField* u = field())
      tracker.advect(*u, dt);
    else
      tracker.displace(positions(tracker.surface(), dt), dt);
  }
};

}  // namespace suture::sims
