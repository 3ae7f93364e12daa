// Volume control: each body of liquid is given the divergence that brings back what it has lost.
#include "sims/fluid/effects/volume_control.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "kernel/errors.h"
#include "sims/fluid/liquid/component_tracking.h"

namespace suture::sims {
namespace {

/// The gain of the integral part beside the other one.
double gain(const VolumeControlOptions& options) {
  return 1 / (4 * options.damping * options.damping);
}

/// The sums of what the bodies of a group had and should have.
struct Group {
  bool known = false;
  double target = 0, integral = 0;  ///< integral: weighted by target
  double volume = 0;                ///< now
  std::uint32_t largest = kNone;    ///< body now; takes what rounding leaves of the target
};

/// Groups without a body on one side become one with that of the largest body now.
std::vector<std::uint32_t> with_both_sides(const ComponentGroups& groups,
                                           const std::vector<VolumeControl::Body>& now) {
  std::vector<std::uint8_t> before(groups.count, 0), after(groups.count, 0);
  for (const std::uint32_t g : groups.before) before[g] = 1;
  for (const std::uint32_t g : groups.after) after[g] = 1;
  const auto smaller = [](const VolumeControl::Body& a, const VolumeControl::Body& b) {
    return a.volume < b.volume;
  };
  const auto largest = std::max_element(now.begin(), now.end(), smaller) - now.begin();
  std::vector<std::uint32_t> joined(groups.count);
  for (std::uint32_t g = 0; g < groups.count; ++g)
    joined[g] = before[g] != 0 && after[g] != 0 ? g : groups.after[largest];
  return joined;
}

/// Gives the bodies now the targets of those before. \pre there is a body now
void hand_on(const std::vector<VolumeControl::Body>& before, const ComponentGroups& groups,
             std::vector<VolumeControl::Body>& now) {
  const std::vector<std::uint32_t> joined = with_both_sides(groups, now);
  std::vector<Group> all(groups.count);
  for (std::size_t b = 0; b < before.size(); ++b) {
    Group& group = all[joined[groups.before[b]]];
    group.known = true;
    group.target += before[b].target;
    group.integral += before[b].integral * before[b].target;
  }
  for (std::uint32_t b = 0; b < now.size(); ++b) {
    Group& group = all[joined[groups.after[b]]];
    group.volume += now[b].volume;
    if (group.largest == kNone || now[b].volume > now[group.largest].volume) group.largest = b;
  }
  std::vector<double> left;
  for (const Group& group : all) left.push_back(group.target);
  for (std::uint32_t b = 0; b < now.size(); ++b) {
    const std::uint32_t g = joined[groups.after[b]];
    const Group& group = all[g];
    if (!group.known) continue;  // there was nothing at all before
    if (group.target > 0) now[b].integral = group.integral / group.target;
    if (b == group.largest) continue;
    now[b].target = group.volume > 0 ? group.target * (now[b].volume / group.volume) : 0;
    left[g] -= now[b].target;
  }
  for (std::size_t g = 0; g < groups.count; ++g)
    if (all[g].known && all[g].largest != kNone) now[all[g].largest].target = left[g];
}

class VolumeControlEffect final : public Effect {
 public:
  VolumeControlEffect(const VolumeControlOptions& options, const ModuleAccount& account)
      : options_(options), account_(account) {}

  void project(const StepState& step, ProjectionTerms& terms) override {
    std::vector<double> wanted;
    account_.timed([&] {
      if (!control_) control_.emplace(step.surface, options_);
      wanted = control_->divergence(NearestTriangle(step.surface), step.domain.liquid, step.dt);
    });
    account_.holds(control_->memory() + wanted.size() * sizeof(double));
    terms.add_divergence(std::move(wanted));
  }

  void before_move(SurfaceTracker& surface) override {
    if (control_ && !surface.keeps_triangles()) before_remodel(surface.surface());
  }
  void after_move(SurfaceTracker& surface, const SurfacePath& path) override {
    if (!control_) return;
    account_.timed([&] {
      if (surface.keeps_triangles())
        control_->moved(surface.surface());
      else
        control_->after_remodel(surface.surface(), path);
    });
  }
  void before_remodel(const Triangles& surface) override {
    if (control_) account_.timed([&] { control_->before_remodel(surface); });
  }
  void after_remodel(const Triangles& surface) override {
    if (control_) account_.timed([&] { control_->after_remodel(surface); });
  }

 private:
  VolumeControlOptions options_;
  ModuleAccount account_;
  std::optional<VolumeControl> control_;  ///< from the first step on
};

}  // namespace

VolumeControl::VolumeControl(const Triangles& surface, const VolumeControlOptions& options)
    : options_(options), parts_(liquid_bodies(surface)) {
  check(options, volume_control_options(), "volume control: ");
  const BodyMeasures now = measure(surface, parts_);
  for (std::size_t b = 0; b < parts_.count; ++b)
    bodies_.push_back({now.volume[b], now.volume[b], now.area[b], 0});
}

void VolumeControl::moved(const Triangles& surface) {
  if (remodelling_ || surface.triangles.size() != parts_.of_triangle.size())
    throw InvalidInput(
        "volume control: the surface has other triangles than before; call before_remodel and "
        "after_remodel round what changes them");
  const BodyMeasures now = measure(surface, parts_);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b].volume = now.volume[b];
    bodies_[b].area = now.area[b];
  }
}

void VolumeControl::before_remodel(const Triangles& surface) {
  moved(surface);
  before_ = surface;
  remodelling_ = true;
}

void VolumeControl::after_remodel(const Triangles& surface, const SurfacePath& move) {
  if (!remodelling_)
    throw InvalidInput("volume control: after_remodel needs a before_remodel first");
  if (move)
    for (Point& p : before_.positions) p = move(p);
  LiquidBodies parts = liquid_bodies(surface);
  const ComponentGroups groups = track_components({before_, parts_}, {surface, parts});
  const BodyMeasures now = measure(surface, parts);
  std::vector<Body> bodies(parts.count);
  for (std::size_t b = 0; b < parts.count; ++b)
    bodies[b] = {now.volume[b], now.volume[b], now.area[b], 0};
  if (!bodies.empty()) hand_on(bodies_, groups, bodies);
  bodies_ = std::move(bodies);
  parts_ = std::move(parts);
  before_ = {};
  remodelling_ = false;
}

double VolumeControl::rate(Body& body, double h, double dt) const {
  if (!(body.volume >= h * h * h) || !(body.target > 0)) return 0;
  const double error = body.volume / body.target - 1, per_step = 1 / options_.relaxation;
  const auto wanted = [&] {  // volume a step
    return -(error + gain(options_) * body.integral) * per_step * body.target;
  };
  const double most = options_.most_shift * h * body.area;
  if (std::abs(wanted()) < most) {
    const double bound = options_.most_integral / gain(options_);
    body.integral = std::clamp(body.integral + error * per_step, -bound, bound);
  }
  return std::clamp(wanted(), -most, most) / (body.volume * dt);
}

std::vector<double> VolumeControl::divergence(const NearestTriangle& nearest, const Liquid& liquid,
                                              double dt) {
  if (!(dt > 0) || !std::isfinite(dt))
    throw InvalidInput("volume control: the time step is " + number(dt) +
                       "; it must be finite and above 0");
  std::vector<double> rates;
  for (Body& body : bodies_) rates.push_back(rate(body, liquid.grid->h(), dt));
  const std::vector<std::uint32_t> of_cell = bodies_of_cells(parts_, nearest, liquid);
  std::vector<double> wanted(of_cell.size(), 0);
  for (Slot s = 0; s < wanted.size(); ++s)
    if (of_cell[s] != kNone) wanted[s] = rates[of_cell[s]];
  return wanted;
}

std::size_t VolumeControl::memory() const {
  return sizeof *this + parts_.of_triangle.capacity() * sizeof(std::uint32_t) +
         bodies_.capacity() * sizeof(Body) + before_.positions.capacity() * sizeof(Point) +
         before_.triangles.capacity() * sizeof(Triangle);
}

std::unique_ptr<Effect> make_volume_control(const VolumeControlOptions& options,
                                            const ModuleAccount& account) {
  return std::make_unique<VolumeControlEffect>(options, account);
}

}  // namespace suture::sims
