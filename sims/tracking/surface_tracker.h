// The interface of everything that keeps a moving surface: a mesh, or a baseline to compare with.
#pragma once

#include <vector>

#include "sims/support/clock.h"
#include "surgery/tracker.h"

namespace suture::sims {

/// The cost of a tracker so far, with counts such as cells re-sampled or particles.
using TrackerCost = Costs;

/// Owns a surface in whatever form it keeps it. Lengths and times are in the scene's unit. Every
/// tracker serves advect; calls that it cannot serve throw InvalidInput and change nothing.
class SurfaceTracker {
 public:
  virtual ~SurfaceTracker() = default;

  /// Whether the surface is a mesh that keeps its vertices and triangles while it moves. Such a
  /// tracker serves displace, remodel and improve, and no other does.
  virtual bool keeps_triangles() const { return false; }

  /// Moves the surface along u from time() to time() + dt.
  /// \throw InvalidInput if u leads out of the finite numbers or of what the method can hold
  virtual void advect(const VelocityField& u, double dt) = 0;

  /// Gives every vertex a new position, in the order of surface().positions, and adds dt to time().
  /// \throw InvalidInput as Tracker::displace, and unless keeps_triangles()
  virtual void displace(std::vector<Point> positions, double dt = 0);

  /// Changes the topology where that is due, as Tracker::remodel.
  /// \throw InvalidInput as that, and unless keeps_triangles()
  virtual SurgeryReport remodel();

  /// Improves the triangles, as Tracker::improve. \throw as that, and InvalidInput unless
  /// keeps_triangles()
  virtual QualityReport improve();

  /// Ends a frame: the method does now what it else does only every few steps, such as making its
  /// values distances again. A mesh has nothing of the kind.
  virtual void end_of_frame() = 0;

  /// The surface, closed and oriented outwards; empty where nothing is left. A baseline contours it
  /// when it is first asked for. The reference holds until the next call that changes the surface.
  virtual const Triangles& surface() = 0;

  /// Signed distance at p, negative inside; a method with a band gives ± its width beyond it. The
  /// first question since the surface moved may prepare something; then any number of threads may
  /// ask. \pre the surface is not empty
  virtual double distance(const Point& p) = 0;

  /// The sum of every dt so far.
  virtual double time() const = 0;
  virtual TrackerCost cost() const = 0;
};

}  // namespace suture::sims
