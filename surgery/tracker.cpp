// The tracker's state, and the order in which the paper's steps run [§3].
#include "surgery/tracker.h"

#include "kernel/errors.h"
#include "surgery/advect.h"

namespace suture {

struct Tracker::State {
  Triangles surface;
  TrackerOptions options;
  double time = 0;
};

Tracker::Tracker(Triangles surface, const TrackerOptions& options)
    : state_(std::make_unique<State>(State{std::move(surface), options})) {}
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

const Triangles& Tracker::surface() const { return state_->surface; }
const TrackerOptions& Tracker::options() const { return state_->options; }
double Tracker::time() const { return state_->time; }

void Tracker::advect(const VelocityField& u, double dt) {
  displace(advected(state_->surface.positions, u, state_->time, dt), dt);
}

void Tracker::displace(std::vector<Point> positions, double dt) {
  if (positions.size() != state_->surface.positions.size())
    throw InvalidInput("displace was given " + std::to_string(positions.size()) +
                       " positions for a surface of " +
                       std::to_string(state_->surface.positions.size()) +
                       " vertices; give one for each, in the order of surface().positions");
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!positions[i].allFinite())
      throw InvalidInput("vertex " + std::to_string(i) +
                         " would move to a place that is not finite; "
                         "check the velocity field or the time step");
  state_->surface.positions = std::move(positions);
  state_->time += dt;
}

SurgeryReport Tracker::remodel(Trace*) { return {}; }
QualityReport Tracker::improve(Trace*) { return {}; }

}  // namespace suture
