// Surface tension: the pressure jump that curvature makes at the faces of the physics grid that the
// surface crosses, and what the surface does of itself.
#include "sims/fluid/effects/surface_tension.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "kernel/errors.h"
#include "sims/fluid/effects/tension/surface_velocity.h"

namespace suture::sims {
namespace {

constexpr double kOnSolid = 0.25;  // cells: a vertex so near a solid lies on it

std::vector<std::uint8_t> lies_on_solid(const StepState& step, double h) {
  std::vector<std::uint8_t> flags;
  if (!step.solids.any()) return flags;
  for (const Point& p : step.surface.positions)
    flags.push_back(step.solids.distance(p, step.time) < kOnSolid * h ? 1 : 0);
  return flags;
}

class SurfaceTension final : public Effect {
 public:
  SurfaceTension(const TensionOptions& options, const ModuleAccount& account)
      : options_(options), account_(account) {}

  double longest_step() const override { return capillary_step(options_); }

  void project(const StepState& step, ProjectionTerms& terms) override {
    part_ = stable_part(options_, step.dt);
    TensionOptions acting = options_;
    acting.tension = part_ * options_.tension;
    std::array<std::vector<double>, 3> jump;
    account_.timed([&] {
      const std::vector<std::uint8_t> flags = lies_on_solid(step, options_.h);
      CurvatureOptions curvature;
      if (!flags.empty()) curvature.on_solid = &flags;
      const NearestTriangle nearest(step.surface);
      const Filtered<double> curved = mean_curvature(step.surface, acting.h, curvature);
      account_.checked(curved.solve);
      jump =
          tension_jump({step.surface, nearest, curved.values}, step.domain.liquid, acting.tension);
      Filtered<Point> ripples = ripple_velocity(step.surface, acting, curvature);
      account_.checked(ripples.solve);
      ripples_.emplace(step.surface, std::move(ripples.values));
    });
    account_.holds(3 * jump[0].size() * sizeof(double) + ripples_->memory() +
                   step.surface.positions.size() * sizeof(double));
    terms.add_jump(std::move(jump));
  }

  void report(FluidStep& step) const override { step.tension_share = part_; }

  Point of_surface(const Point& p) const override {
    return ripples_ ? ripples_->at(p) : Point(Point::Zero());
  }

 private:
  TensionOptions options_;
  ModuleAccount account_;
  double part_ = 1;  ///< of the tension, that the last step held stable
  std::optional<SurfaceVelocity> ripples_;
};

}  // namespace

std::array<std::vector<double>, 3> tension_jump(const CurvedSurface& curved, const Liquid& liquid,
                                                double tension) {
  std::array<std::vector<double>, 3> jump;
  for (std::vector<double>& along : jump) along.assign(liquid.grid->size(), 0);
  for_each_crossing(liquid, [&](int axis, Slot face, Slot, const Point& at) {
    const SurfacePlace place = nearest_place(curved.surface, curved.nearest, at);
    for (int k = 0; k < 3; ++k)
      jump[axis][face] += tension * place.weights[k] * curved.curvature[place.corners[k]];
  });
  return jump;
}

double capillary_step(const TensionOptions& options) {
  const auto& [tension, density, h] = options;
  if (!(h > 0) || !std::isfinite(h) || !(density > 0) || !std::isfinite(density) ||
      !(tension >= 0) || !std::isfinite(tension))
    throw InvalidInput(
        "a capillary wave needs a finite positive cell size and density, and a tension that is not "
        "negative; they are " +
        number(h) + ", " + number(density) + " and " + number(tension));
  return h * std::sqrt(density * h / (4 * std::numbers::pi * tension));
}

double stable_part(const TensionOptions& options, double dt) {
  if (!(dt > 0)) throw InvalidInput("surface tension: a step must be above 0 long");
  const double part = capillary_step(options) / dt;
  return part < 1 ? part * part : 1;
}

Filtered<Point> ripple_velocity(const Triangles& surface, const TensionOptions& options,
                                CurvatureOptions curvature) {
  curvature.smoothing /= 2;
  Filtered<Point> velocity = ripples(surface, options.h, curvature);
  const double rate = kRippleRate / capillary_step(options);
  for (Point& v : velocity.values) v *= rate;
  return velocity;
}

std::unique_ptr<Effect> make_surface_tension(const TensionOptions& options,
                                             const ModuleAccount& account) {
  return std::make_unique<SurfaceTension>(options, account);
}

}  // namespace suture::sims
