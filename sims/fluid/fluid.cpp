// The fluid: velocity on a sparse staggered grid, a client of any surface tracker [§7].
#include "sims/fluid/fluid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "kernel/errors.h"
#include "sims/fluid/effects/effects.h"
#include "sims/fluid/liquid/subgrid_droplets.h"
#include "sims/fluid/options_table.h"
#include "sims/fluid/pressure.h"
#include "sims/fluid/solids/wall_projection.h"

namespace suture::sims {
namespace {

constexpr int kBand = 3;         // cells round the liquid that exist whatever the step
constexpr int kWidestBand = 40;  // and at most, for steps across many cells

std::size_t memory(const MacVelocity& velocity) {
  return 3 * velocity.u[0].size() * (sizeof(double) + 1);
}

/// The velocity that a scene begins with, where the liquid is.
MacVelocity sampled(const Fluid::Initial& initial, const Liquid& liquid) {
  MacVelocity velocity(*liquid.grid);
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
  Solids solids;
  std::unique_ptr<SparseGrid> grid;  ///< what velocity and liquid are on
  Liquid liquid;
  std::vector<Drop> drops;
  std::optional<DropsAtSolids> at_solids;  ///< of this step
  SolidFaces faces;
  MacVelocity velocity;
  double time = 0, last_dt = 0;
  double since_surgery = 0;  ///< cells that the fastest liquid has crossed since the last surgery
  FluidStep last;
  ModuleCosts costs;
  std::unique_ptr<Effects> effects;

  bool started() const { return grid != nullptr; }
  double fall(double dt) const { return options.gravity.lpNorm<Eigen::Infinity>() * dt; }
  int band(double dt) const;
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

/// A grid round the surface as it is now, with the velocity that the liquid brings along.
void Fluid::State::carry(SurfaceTracker& surface, double dt) {
  const double by = 0.5 * (last_dt + dt);
  const auto distance = [&](const Point& p) { return surface.distance(p); };
  std::unique_ptr<SparseGrid> old;
  costs.timed("grid", [&] {
    const LiquidCells cells =
        find_liquid(surface.surface(), distance, options.origin, options.cell_size);
    auto next = std::make_unique<SparseGrid>(grid_round(cells, band(dt)));
    liquid = liquid_on(*next, cells, surface.surface(), solids, time);
    drops = cells.drops;
    last.drops = drops.size();
    old = std::exchange(grid, std::move(next));
  });
  if (old) effects->carry(velocity, liquid, last_dt);
  costs.timed("advection", [&] {
    velocity = old ? carried(velocity, liquid, by, options.advection) : sampled(initial, liquid);
  });
  costs.holds("grid", liquid.memory());
  costs.holds("advection", 2 * memory(velocity));
}

void Fluid::State::make_incompressible(const StepState& step) {
  const ProjectionInput input{liquid,  step.faces,          options.density,
                              step.dt, effects->jump(step), effects->divergence(step)};
  costs.timed("pressure", [&] {
    const SolveReport solved = project(velocity, input, options.pressure);
    costs.iterated("pressure", solved.iterations, solved.residual);
    last.residual = solved.residual;
  });
  costs.holds("pressure", grid->size() * (6 * sizeof(double) + 1));
}

void Fluid::State::advect(SurfaceTracker& surface, const VelocityField& field, double dt) {
  surface.advect(field, dt);
  if (!at_solids || !at_solids->any()) return;
  std::vector<Point> positions = surface.surface().positions;
  at_solids->put(positions);
  surface.displace(std::move(positions));
}

void Fluid::State::move(SurfaceTracker& surface, double dt) {
  const double h = options.cell_size;
  const bool keeps = keeps_out(surface);
  const VelocityField field = [&](const Point& p, double) {
    const Point v = velocity.at(p) + effects->of_surface(p);
    return keeps ? kept_out(solids, p, v, time, dt, h) : v;
  };
  effects->moving(
      surface, [&] { costs.timed("surface", [&] { advect(surface, field, dt); }); },
      [&](const Point& p) -> Point { return p + dt * field(p + 0.5 * dt * field(p, 0), 0); });
}

Fluid::Fluid(FluidOptions options, Initial initial) : state_(std::make_unique<State>()) {
  check(options);
  for (const SolidOptions& s : options.solids)
    state_->solids.all.push_back(make_solid(s, options.origin, options.cell_size));
  state_->options = std::move(options);
  state_->effects = std::make_unique<Effects>(state_->options, state_->costs);
  state_->initial = std::move(initial);
}

Fluid::~Fluid() = default;

double Fluid::longest_step() const {
  const State& s = *state_;
  const FluidOptions& o = s.options;
  if (s.started() && s.grid->size() == 0)  // no liquid is left that could be too fast
    return std::numeric_limits<double>::infinity();
  const double speed =
      std::max(s.started() ? largest_component(s.velocity) : 0, s.solids.fastest());
  // What falls with g from this speed crosses cfl cells in the root of g t² + speed t = cfl h.
  const double reach = o.cfl * o.cell_size, g = s.fall(1);
  return std::min(2 * reach / (speed + std::sqrt(speed * speed + 4 * g * reach)),
                  s.effects->longest_step());
}

int Fluid::most_steps() const { return state_->options.most_steps; }

/// The velocity to the middle of the next dt.
void Fluid::State::bring_forward(SurfaceTracker& surface, double dt) {
  const double by = 0.5 * (last_dt + dt), then = time + 0.5 * dt;
  carry(surface, dt);
  add_force(velocity, options.gravity * by);
  if (solids.any()) {
    costs.timed("solids", [&] { faces = faces_of(solids, *grid, then); });
    costs.holds("solids", faces.memory() + solids.memory());
  }
  StepState step{velocity, liquid, faces, solids, surface.surface(), time, by};
  effects->stress(step);
  make_incompressible(step);
  if (!drops.empty() && keeps_out(surface))
    costs.timed("solids", [&] {
      at_solids.emplace(drops, surface.surface(), liquid, solids, time, dt, velocity);
    });
  costs.timed("extrapolation", [&] { extrapolate(velocity, band(dt)); });
  step.dt = dt;
  effects->flowed(step);
  if (solids.any()) costs.timed("solids", [&] { constrain(velocity, faces, solids, then); });
  require_finite(velocity);
  last.tension_share = effects->tension_share();
  last.cells = grid->size();
  last.liquid = static_cast<std::size_t>(std::count_if(
      liquid.distance.begin(), liquid.distance.end(), [](double d) { return d < 0; }));
  last.cfl = largest_component(velocity) * dt / options.cell_size;
}

/// No liquid is left: nothing is told of what there was.
void Fluid::State::dry_up() {
  auto none =
      std::make_unique<SparseGrid>(options.origin, options.cell_size, std::vector<Index3>{});
  liquid = {};
  liquid.grid = none.get();
  if (started()) effects->carry(velocity, liquid, last_dt);
  velocity = MacVelocity(*none);
  drops.clear();
  faces = {};
  last = {};
  grid = std::move(none);
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
  state_->effects->before_remodel(surface.surface());
}
void Fluid::after_remodel(SurfaceTracker& surface) {
  state_->effects->after_remodel(surface.surface());
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
  return measure_liquid(s.velocity, s.liquid, s.faces, s.options.density, s.options.gravity);
}
const FluidStep& Fluid::last() const { return state_->last; }
std::vector<ModuleCost> Fluid::costs() const { return state_->costs.all(); }

}  // namespace suture::sims
