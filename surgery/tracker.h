// The tracker: a closed surface that moves, splits and merges. Simulators see no more of it [§3].
#pragma once

#include <memory>

#include "kernel/trace.h"
#include "kernel/triangles.h"
#include "surgery/advect.h"
#include "surgery/detect/surface_distance.h"
#include "surgery/model/options.h"
#include "surgery/model/report.h"

namespace suture {

/// Owns the surface. Each call either does what it says or leaves the surface as it was.
class Tracker {
 public:
  /// Cells may be 2^-800 to 2^1000 long: in that range a scene × 2^k gives the same bits × 2^k, but
  /// for coordinates that would be subnormal.
  /// \throw InvalidInput unless `surface` is a closed, oriented, edge- and vertex-manifold, finite,
  /// non-empty triangle mesh, the options are in range and the lattice fits doubles and indices
  Tracker(Triangles surface, const TrackerOptions& options);
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  const Triangles& surface() const;
  const TrackerOptions& options() const;
  double time() const;

  /// Moves every vertex along u by the classic Runge–Kutta method of order 4, from time() to
  /// time()+dt [§4]. \throw InvalidInput as displace; the surface then stays
  void advect(const VelocityField& u, double dt);

  /// Gives every vertex a new position, in the order of surface().positions, and adds dt to time().
  /// \throw InvalidInput if the count differs, a position is not finite, or the lattice no longer
  /// fits round them; the surface then stays
  void displace(std::vector<Point> positions, double dt = 0);

  /// The signed distance field of the surface as it is now; computes nothing until it is asked
  /// [§5.1]. \pre the surface is not empty
  SurfaceDistance distance() const;

  /// Finds where topology should change and re-samples the surface there, and only there [§5, §6].
  /// \throw InvalidInput if the surface now crosses the lattice too often for the memory, or this
  /// thread rounds other than to nearest or flushes subnormal numbers
  SurgeryReport remodel(Trace* trace = nullptr);

  /// Subdivides, collapses and flips until edges and angles are as options().quality asks [§6.2].
  /// \throw InternalFailure if the audit objects; the surface then stays
  QualityReport improve(Trace* trace = nullptr);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace suture
