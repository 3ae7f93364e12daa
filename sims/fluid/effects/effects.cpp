// What a scene names beyond an inviscid liquid, each made only where it does.
#include "sims/fluid/effects/effects.h"

#include <limits>

#include "sims/fluid/effects/surface_tension.h"
#include "sims/fluid/effects/tension/surface_velocity.h"
#include "sims/fluid/effects/viscosity.h"

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

}  // namespace

struct Effects::State {
  const FluidOptions& options;
  ModuleCosts& costs;
  ElasticOptions elastic;               ///< with the liquid's density
  Strain strain;                        ///< empty where the scene names no elasticity
  std::optional<VolumeControl> volume;  ///< from the first step on, if the scene names it
  std::array<std::vector<double>, 3> jump;
  double tension_share = 1;
  std::optional<SurfaceVelocity> ripples;  ///< with surface tension
  std::vector<double> divergence;

  void viscosity(const StepState& step);
  void elasticity(const StepState& step);
};

Effects::Effects(const FluidOptions& options, ModuleCosts& costs)
    : state_(new State{options, costs, {}, {}, {}, {}, 1, {}, {}}) {
  if (options.viscoelasticity) state_->elastic = *options.viscoelasticity;
  state_->elastic.density = options.density;
}

Effects::~Effects() = default;

double Effects::longest_step() const {
  const FluidOptions& o = state_->options;
  return o.surface_tension ? capillary_step(o.cell_size, o.density, *o.surface_tension)
                           : std::numeric_limits<double>::infinity();
}

void Effects::State::viscosity(const StepState& step) {
  costs.timed("viscosity", [&] {
    const DiffusionReport done = diffuse(step.velocity, step.liquid, step.faces,
                                         {*options.viscosity, options.density, options.no_slip},
                                         step.dt, options.viscous_solver);
    costs.iterated("viscosity", done.iterations, done.residual);
    costs.holds("viscosity", done.memory);
  });
}

void Effects::State::elasticity(const StepState& step) {
  costs.timed("viscoelasticity", [&] {
    if (strain.grid == nullptr) strain = unstrained(*step.liquid.grid, elastic);
    const DiffusionReport done = push(step.velocity, strain, step.liquid, step.faces, elastic,
                                      step.dt, options.viscous_solver);
    costs.iterated("viscoelasticity", done.iterations, done.residual);
    costs.holds("viscoelasticity", strain.memory() + done.memory);
  });
}

void Effects::stress(const StepState& step) {
  if (state_->options.viscosity) state_->viscosity(step);
  if (state_->options.viscoelasticity) state_->elasticity(step);
}

void Effects::carry(const MacVelocity& old, const Liquid& liquid, double dt) {
  State& s = *state_;
  if (!s.strain.any()) return;
  s.costs.timed("viscoelasticity",
                [&] { s.strain = carried(s.strain, old, *liquid.grid, liquid, dt); });
}

void Effects::flowed(const StepState& step) {
  State& s = *state_;
  if (!s.strain.any()) return;
  s.costs.timed("viscoelasticity", [&] {
    stretch(s.strain, step.velocity, step.liquid, step.faces, s.elastic, step.dt);
  });
}

const std::array<std::vector<double>, 3>* Effects::jump(const StepState& step) {
  State& s = *state_;
  if (!s.options.surface_tension) return nullptr;
  const double h = s.options.cell_size, all = *s.options.surface_tension;
  s.tension_share = stable_share(step.dt, h, s.options.density, all);
  const double tension = s.tension_share * all;
  s.costs.timed("surface_tension", [&] {
    const std::vector<std::uint8_t> flags = lies_on_solid(step, h);
    CurvatureOptions curvature;
    if (!flags.empty()) curvature.on_solid = &flags;
    s.jump = tension_jump(step.surface, NearestTriangle(step.surface),
                          mean_curvature(step.surface, h, curvature), step.liquid, tension);
    s.ripples.emplace(step.surface,
                      ripple_velocity(step.surface, h, s.options.density, tension, curvature));
  });
  s.costs.holds("surface_tension", 3 * s.jump[0].size() * sizeof(double) + s.ripples->memory() +
                                       step.surface.positions.size() * sizeof(double));
  return &s.jump;
}

double Effects::tension_share() const { return state_->tension_share; }

const std::vector<double>* Effects::divergence(const StepState& step) {
  State& s = *state_;
  if (!s.options.volume_control) return nullptr;
  s.costs.timed("volume_control", [&] {
    if (!s.volume) s.volume.emplace(step.surface, *s.options.volume_control);
    s.divergence = s.volume->divergence(NearestTriangle(step.surface), step.liquid, step.dt);
  });
  s.costs.holds("volume_control", s.volume->memory() + s.divergence.size() * sizeof(double));
  return &s.divergence;
}

Point Effects::of_surface(const Point& p) const {
  return state_->ripples ? state_->ripples->at(p) : Point(Point::Zero());
}

void Effects::moving(SurfaceTracker& surface, const std::function<void()>& advect,
                     const std::function<Point(const Point&)>& move) {
  State& s = *state_;
  if (!s.volume) return advect();
  const bool follows = surface.keeps_triangles();
  if (!follows) before_remodel(surface.surface());
  advect();
  s.costs.timed("volume_control", [&] {
    if (follows)
      s.volume->moved(surface.surface());
    else
      s.volume->after_remodel(surface.surface(), move);
  });
}

void Effects::before_remodel(const Triangles& surface) {
  State& s = *state_;
  if (s.volume) s.costs.timed("volume_control", [&] { s.volume->before_remodel(surface); });
}

void Effects::after_remodel(const Triangles& surface) {
  State& s = *state_;
  if (s.volume) s.costs.timed("volume_control", [&] { s.volume->after_remodel(surface); });
}

}  // namespace suture::sims
