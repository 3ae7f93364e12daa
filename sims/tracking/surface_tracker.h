// Any way to track a moving surface, seen alike: what a measurement or a solver asks of it.
#pragma once

#include <vector>

#include "sims/support/clock.h"
#include "surgery/tracker.h"

namespace suture::sims {

/// What a tracker has spent so far, and counts such as cells re-sampled or particles.
using TrackerCost = Costs;

/// Told of each part of a step as it ends, before the motion hears of the changed surface.
class StepWatcher {
 public:
  virtual ~StepWatcher() = default;
  virtual void moved(double /*dt*/) {}
  virtual void remodelled(const SurgeryReport& /*report*/) {}
  virtual void improved(const QualityReport& /*report*/) {}
};

/// Owns a surface in whatever form it keeps it. Lengths and times are in the scene's unit.
class SurfaceTracker {
 public:
  virtual ~SurfaceTracker() = default;

  /// Moves the surface along u from time() to time() + dt, with all that belongs to the method at
  /// every step or every few (remodels, re-initialisation, re-seeding).
  /// \throw InvalidInput if u leads out of the finite numbers or of what the method can hold
  virtual void advect(const VelocityField& u, double dt) = 0;

  /// What the method else does every few steps, now: before a measurement, or at a frame's end.
  virtual void settle() = 0;

  /// The surface, closed and oriented outwards; empty where nothing is left. Contoured when it is
  /// first asked for; the reference holds until the next advect or settle.
  virtual const Triangles& surface() = 0;

  /// Signed distance at p, negative inside; methods with a band give ± its width beyond it. The
  /// first question since the surface moved may prepare something; then any number of threads may
  /// ask. \pre the surface is not empty
  virtual double distance(const Point& p) = 0;

  /// Who is told of remodels and improvements from now on, where the method has these; null:
  /// nobody.
  virtual void watch(StepWatcher* /*watcher*/) {}

  /// Whether advect moves vertices and leaves the triangles as they are.
  virtual bool keeps_triangles() const { return false; }

  /// Gives every vertex a new position, in the order of surface().positions, at the time it is.
  /// \pre keeps_triangles() \throw InvalidInput as Tracker::displace
  virtual void displace(std::vector<Point> /*positions*/) {}

  virtual double time() const = 0;
  virtual TrackerCost cost() const = 0;
};

}  // namespace suture::sims
