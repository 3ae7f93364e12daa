// The fluid: velocity on a sparse staggered grid, a client of any surface tracker [§7].
#include "sims/fluid/fluid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "kernel/errors.h"
#include "sims/fluid/effect_registry.h"
#include "sims/fluid/liquid/subgrid_droplets.h"
#include "sims/fluid/solids/wall_projection.h"
#include "sims/fluid/velocity/pressure.h"

namespace suture::sims {
namespace {

constexpr int kBand = 3;         // cells round the liquid that exist whatever the step
constexpr int kWidestBand = 40;  // and at most, for steps across many cells

[[noreturn]] void refuse(const char* what) { throw InvalidInput(std::string("fluid: ") + what); }

bool positive(double x) { return x > 0 && std::isfinite(x); }

void check(const FluidOptions& o) {
  if (!positive(o.cell_size)) refuse("cell_size must be finite and above 0");
  if (!positive(o.density)) refuse("density must be finite and above 0");
  if (!o.gravity.allFinite() || !o.origin.allFinite()) refuse("gravity and origin must be finite");
  if (!positive(o.cfl)) refuse("cfl must be finite and above 0");
  if (o.most_steps <= 0) refuse("most_steps must be 1 or more");
  if (!(o.topology_cells > 0)) refuse("topology_cells must be above 0");
  for (const SolverOptions& s : {o.pressure, o.viscous_solver})
    if (!(s.tolerance > 0) || s.tolerance > 1 || s.most_iterations <= 0)
      refuse("a solver's tolerance must be above 0 and at most 1, and most_iterations 1 or more");
}

std::size_t memory(const MacVelocity& velocity) {
  return 3 * velocity.u[0].size() * (sizeof(double) + 1);
}

/// The velocity that a scene begins with, where the liquid is.
MacVelocity sampled(const Fluid::Initial& initial, const Liquid& liquid) {
  MacVelocity velocity(liquid.grid);
  for_each_carried_face(liquid, [&](int axis, Slot s) {
    velocity.u[axis][s] = initial(liquid.grid->face(liquid.grid->cell(s), axis))[axis];
    velocity.known[axis][s] = 1;
  });
  return velocity;
}

void add_force(MacVelocity& velocity, const Point& change) {
  for (int a = 0; a < 3; ++a) {
    if (change[a] == 0) continue;
    for (Slot s = 0; s < velocity.u[a].size(); ++s)
      if (velocity.known[a][s] != 0) velocity.u[a][s] += change[a];
  }
}

void require_finite(const MacVelocity& velocity) {
  for (int a = 0; a < 3; ++a)
    for (Slot s = 0; s < velocity.u[a].size(); ++s)
      if (velocity.known[a][s] != 0 && !std::isfinite(velocity.u[a][s]))
        throw InvalidInput(
            "fluid: a velocity is beyond the finite numbers; take shorter steps (cfl), or a force "
            "that the scene's unit can hold");
}

}  // namespace

struct Fluid::State {
  FluidOptions options;
  Initial initial;
  ModuleCosts costs;
  std::vector<std::unique_ptr<Effect>> effects;  ///< in the order in which they act
  Solids solids;
  Liquid liquid;
  std::vector<SubgridDroplet> droplets;
  std::optional<DropletsAtSolids> at_solids;  ///< of this step
  SolidFaces faces;
  MacVelocity velocity;
  double time = 0, last_dt = 0;
  double since_surgery = 0;  ///< cells that the fastest liquid has crossed since the last surgery
  FluidStep last;

  bool started() const { return liquid.grid != nullptr; }
  double fall(double dt) const { return options.gravity.lpNorm<Eigen::Infinity>() * dt; }
  int band(double dt) const;
  void find_liquid(SurfaceTracker& surface, double dt);
  void carry(SurfaceTracker& surface, double dt);
  void make_incompressible(const StepState& step);
  void bring_forward(SurfaceTracker& surface, double dt);
  /// Vertices are kept out of solids; a level set moves there too, along them, or the air behind a
  /// wall would be pulled into the liquid.
  bool keeps_out(const SurfaceTracker& surface) const {
    return solids.any() && surface.keeps_triangles();
  }
  void advect(SurfaceTracker& surface, const VelocityField& field, double dt);
  void move(SurfaceTracker& surface, double dt);
  void dry_up();
};

/// Cells round the liquid that the surface and the paths back may come to within a step.
int Fluid::State::band(double dt) const {
  const double speed = (started() ? largest_component(velocity) : 0) + fall(dt);
  const double crossed = std::ceil(speed * dt / options.cell_size);
  return kBand + static_cast<int>(std::min<double>(crossed, kWidestBand));
}

/// Makes a grid round the surface as it is now, and the liquid on it.
void Fluid::State::find_liquid(SurfaceTracker& surface, double dt) {
  const SampledSurface sampled =
      sample_surface(surface.surface(), [&](const Point& p) { return surface.distance(p); },
                     {options.origin, options.cell_size});
  auto grid = std::make_shared<const SparseGrid>(grid_round(sampled, band(dt)));
  liquid = liquid_on(std::move(grid), sampled, surface.surface(), SolidsAt(solids, time));
  droplets = sampled.droplets;
  last.drops = droplets.size();
}

/// A grid round the surface as it is now, with the velocity that the liquid brings along.
void Fluid::State::carry(SurfaceTracker& surface, double dt) {
  const double by = 0.5 * (last_dt + dt);
  const bool first = !started();
  costs.timed("grid", [&] { find_liquid(surface, dt); });
  if (!first)
    for (const auto& effect : effects) effect->carry(velocity, liquid, last_dt);
  costs.timed("advection", [&] {
    velocity = first ? sampled(initial, liquid) : carried(velocity, liquid, by, options.advection);
  });
  costs.holds("grid", liquid.memory());
  costs.holds("advection", 2 * memory(velocity));
}

void Fluid::State::make_incompressible(const StepState& step) {
  ProjectionTerms terms;
  for (const auto& effect : effects) effect->project(step, terms);
  const ProjectionInput input{liquid,
                              faces,
                              options.density,
                              step.dt,
                              terms.jump[0].empty() ? nullptr : &terms.jump,
                              terms.divergence.empty() ? nullptr : &terms.divergence};
  costs.timed("pressure", [&] {
    const SolveReport solved = project(velocity, input, options.pressure);
    costs.solved("pressure", solved);
    last.residual = solved.residual;
  });
  costs.holds("pressure", liquid.grid->size() * (6 * sizeof(double) + 1));
}

void Fluid::State::advect(SurfaceTracker& surface, const VelocityField& field, double dt) {
  surface.advect(field, dt);
  if (!at_solids || !at_solids->any()) return;
  std::vector<Point> positions = surface.surface().positions;
  at_solids->put(positions);
  surface.displace(std::move(positions));
}

void Fluid::State::move(SurfaceTracker& surface, double dt) {
  const WallProjection walls{solids, time, dt, options.cell_size};
  const bool keeps = keeps_out(surface);
  const VelocityField field = [&](const Point& p, double) {
    Point own = Point::Zero();
    for (const auto& effect : effects) own += effect->of_surface(p);
    const Point v = velocity.at(p) + own;
    return keeps ? walls.of_point(p, v) : v;
  };
  for (const auto& effect : effects) effect->before_move(surface);
  costs.timed("surface", [&] { advect(surface, field, dt); });
  const SurfacePath path = [&](const Point& p) -> Point {
    return p + dt * field(p + 0.5 * dt * field(p, 0), 0);
  };
  for (const auto& effect : effects) effect->after_move(surface, path);
}

Fluid::Fluid(FluidOptions options, Initial initial) : state_(std::make_unique<State>()) {
  check(options);
  State& s = *state_;
  s.effects = make_effects(options, s.costs);
  for (const SolidOptions& solid : options.solids)
    s.solids.all.push_back(make_solid(solid, {options.origin, options.cell_size}));
  s.options = std::move(options);
  s.initial = std::move(initial);
}

Fluid::~Fluid() = default;

double Fluid::longest_step() const {
  const State& s = *state_;
  const FluidOptions& o = s.options;
  if (s.started() && s.liquid.grid->size() == 0)  // no liquid is left that could be too fast
    return std::numeric_limits<double>::infinity();
  const double speed =
      std::max(s.started() ? largest_component(s.velocity) : 0, s.solids.fastest());
  // What falls with g from this speed crosses cfl cells in the root of g t² + speed t = cfl h.
  const double reach = o.cfl * o.cell_size, g = s.fall(1);
  double longest = 2 * reach / (speed + std::sqrt(speed * speed + 4 * g * reach));
  for (const auto& effect : s.effects) longest = std::min(longest, effect->longest_step());
  return longest;
}

int Fluid::most_steps() const { return state_->options.most_steps; }

/// Brings the velocity to the middle of the next dt.
void Fluid::State::bring_forward(SurfaceTracker& surface, double dt) {
  const double by = 0.5 * (last_dt + dt), then = time + 0.5 * dt;
  const std::size_t unconverged = costs.unconverged();
  carry(surface, dt);
  add_force(velocity, options.gravity * by);
  if (solids.any()) {
    costs.timed("solids", [&] { faces = faces_of(solids, *liquid.grid, then); });
    costs.holds("solids", faces.memory() + solids.memory());
  }
  StepState step{velocity, {liquid, faces}, solids, surface.surface(), time, by};
  for (const auto& effect : effects) effect->stress(step);
  make_incompressible(step);
  if (!droplets.empty() && keeps_out(surface))
    costs.timed("solids", [&] {
      const WallProjection walls{solids, time, dt, options.cell_size};
      at_solids.emplace(droplets, surface.surface(), walls, liquid, velocity);
    });
  costs.timed("extrapolation", [&] { extrapolate(velocity, band(dt)); });
  step.dt = dt;
  for (const auto& effect : effects) effect->flowed(step);
  if (solids.any())
    costs.timed("solids", [&] { constrain(velocity, faces, SolidsAt(solids, then)); });
  require_finite(velocity);
  for (const auto& effect : effects) effect->report(last);
  last.unconverged = costs.unconverged() - unconverged;
  last.cells = liquid.grid->size();
  last.liquid = static_cast<std::size_t>(std::count_if(
      liquid.distance.begin(), liquid.distance.end(), [](double d) { return d < 0; }));
  last.cfl = largest_component(velocity) * dt / options.cell_size;
}

/// No liquid is left, nor anything that is told of it.
void Fluid::State::dry_up() {
  const bool first = !started();
  liquid = {};
  liquid.grid = shared_grid(options.origin, options.cell_size, {});
  if (!first)
    for (const auto& effect : effects) effect->carry(velocity, liquid, last_dt);
  velocity = MacVelocity(liquid.grid);
  droplets.clear();
  faces = {};
  last = {};
}

void Fluid::step(SurfaceTracker& surface, double dt) {
  State& s = *state_;
  if (!(dt > 0) || !std::isfinite(dt)) throw InvalidInput("fluid: a step must be above 0 long");
  s.at_solids.reset();
  if (surface.surface().triangles.empty())
    s.dry_up();
  else
    s.bring_forward(surface, dt);
  s.move(surface, dt);
  s.since_surgery += s.last.cfl;
  s.last.dt = s.last_dt = dt;
  s.time += dt;
}

void Fluid::before_remodel(SurfaceTracker& surface) {
  const Triangles& now = surface.surface();
  for (const auto& effect : state_->effects) effect->before_remodel(now);
}
void Fluid::after_remodel(SurfaceTracker& surface) {
  const Triangles& now = surface.surface();
  for (const auto& effect : state_->effects) effect->after_remodel(now);
  state_->since_surgery = 0;
}
bool Fluid::wants_topology() const {
  return state_->since_surgery + state_->last.cfl > state_->options.topology_cells;
}

Point Fluid::velocity(const Point& p) const {
  return state_->started() ? state_->velocity.at(p) : state_->initial(p);
}
double Fluid::time() const { return state_->time; }
LiquidMeasures Fluid::measures() const {
  const State& s = *state_;
  if (!s.started()) return {};
  return measure_liquid(s.velocity, {s.liquid, s.faces}, {s.options.density, s.options.gravity});
}
const FluidStep& Fluid::last() const { return state_->last; }
std::vector<ModuleCost> Fluid::costs() const { return state_->costs.all(); }

}  // namespace suture::sims
