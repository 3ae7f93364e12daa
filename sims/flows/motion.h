// What moves the tracker's surface: a velocity field, or a motion that the surface itself decides.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sims/support/keys.h"
#include "surgery/tracker.h"

namespace suture::sims {

/// Moves a tracker's surface forward in time.
class Motion {
 public:
  virtual ~Motion() = default;

  /// Moves the surface from tracker.time() to tracker.time() + dt.
  virtual void advance(Tracker& tracker, double dt) = 0;

  /// The velocity field that it is, which carries any points the same way; null if it is none.
  virtual const VelocityField* field() const { return nullptr; }

  /// Told of each remodel and improvement: the new surface, and where each old vertex went.
  virtual void surface_changed(const Triangles& /*surface*/,
                               const std::vector<std::uint32_t>& /*vertex_map*/) {}
};

/// A motion that carries vertices along a velocity field by RK4 (Tracker::advect).
std::unique_ptr<Motion> make_field_motion(VelocityField field);

/// The names that make_motion knows, in alphabetical order.
std::vector<std::string> motion_names();

/// The motion called `kind`, with its parameters read from `keys`, which may hold nothing else.
/// `velocities` are the bodies' own, one for each vertex; only the motion `bodies` uses them.
/// \throw InvalidInput for an unknown name or parameter, a wrong type, a value out of range
std::unique_ptr<Motion> make_motion(const std::string& kind, Keys& keys,
                                    const std::vector<Point>& velocities);

}  // namespace suture::sims
