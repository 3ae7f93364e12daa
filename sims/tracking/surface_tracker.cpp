// The refusals of a tracker that is no mesh.
#include "sims/tracking/surface_tracker.h"

#include "kernel/errors.h"

namespace suture::sims {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw InvalidInput("this way to track a surface keeps no mesh, so it cannot be " + what +
                     "; move it along a velocity field, or choose a mesh");
}

}  // namespace

void SurfaceTracker::displace(std::vector<Point> /*positions*/, double /*dt*/) {
  refuse("displaced vertex by vertex");
}
SurgeryReport SurfaceTracker::remodel() { refuse("remodelled"); }
QualityReport SurfaceTracker::improve() { refuse("improved"); }

}  // namespace suture::sims
