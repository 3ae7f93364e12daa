// The tables [fluid] and [[solids]] of a scene.
#include "sims/scene/fluid_reader.h"

#include <limits>

#include "sims/scene/bodies_reader.h"

namespace suture::sims {
namespace {

constexpr std::array<Named<VelocityAdvection>, 2> kAdvections = {
    {{"semi_lagrangian", VelocityAdvection::semi_lagrangian},
     {"mac_cormack", VelocityAdvection::mac_cormack}}};
constexpr std::array<Named<SolidKind>, 4> kSolids = {{{"container", SolidKind::container},
                                                      {"box", SolidKind::box},
                                                      {"ball", SolidKind::ball},
                                                      {"mesh", SolidKind::mesh}}};

Box read_box(Keys& keys) {
  Box box;
  box.low = keys.vector("low", Point::Zero());
  box.high = keys.vector("high", Point::Zero());
  if (!(box.low.array() < box.high.array()).all())
    keys.refuse("low", "and high are a box's corners; give each of low below high");
  return box;
}

SolidMotion read_motion(Keys& keys) {
  SolidMotion m;
  m.velocity = keys.vector("velocity", m.velocity);
  m.amplitude = keys.vector("amplitude", m.amplitude);
  m.period = keys.number("period", Range::above(0), m.period);
  return m;
}

SolidOptions read_solid(TomlTable& solid, const std::filesystem::path& folder,
                        const SceneSources& sources, std::vector<std::string>& notes) {
  solid.allow_tables({"parameters"});
  Keys& keys = solid.keys;
  SolidOptions s;
  s.kind = keys.choice("kind", kSolids, s.kind);
  if (s.kind == SolidKind::mesh) {
    s.surface = read_placed(solid, folder, sources, notes).surface;
  } else if (s.kind == SolidKind::ball) {
    s.centre = keys.vector("centre", s.centre);
    s.radius = keys.number("radius", Range::above(0));
  } else {
    s.box = read_box(keys);
  }
  s.motion = read_motion(keys);
  keys.done();
  return s;
}

SolverOptions read_solver(Keys& keys, SolverOptions o) {
  o.tolerance = keys.number("tolerance", Range{0, 1, true}, o.tolerance);
  o.most_iterations =
      static_cast<int>(keys.integer("most_iterations", Range::between(1, 1e6), o.most_iterations));
  return o;
}

/// An effect is there if its table is.
template <class Read>
void read_effect(TomlTable& fluid, const std::string& name, Read read) {
  const auto at = fluid.tables.find(name);
  if (at == fluid.tables.end()) return;
  at->second.allow_tables({});
  read(at->second.keys);
  at->second.keys.done();
}

void read_effects(TomlTable& fluid, FluidOptions& o) {
  fluid.allow_tables({"viscosity", "viscoelasticity", "surface_tension", "volume_control"});
  read_effect(fluid, "viscosity", [&](Keys& keys) {
    o.viscosity = keys.number("viscosity", Range::at_least(0));
    o.no_slip = keys.flag("no_slip", o.no_slip);
    o.viscous_solver = read_solver(keys, o.viscous_solver);
  });
  read_effect(fluid, "viscoelasticity", [&](Keys& keys) {
    ElasticOptions e;
    e.modulus = keys.number("modulus", Range::at_least(0));
    e.yield_strain = keys.number("yield_strain", Range::above(0).or_infinite(), e.yield_strain);
    e.flow_rate = keys.number("flow_rate", Range::at_least(0).or_infinite(), e.flow_rate);
    e.relaxation_time =
        keys.number("relaxation_time", Range::above(0).or_infinite(), e.relaxation_time);
    e.no_slip = keys.flag("no_slip", o.no_slip);  // viscosity's, unless it has its own
    o.viscoelasticity = e;
  });
  read_effect(fluid, "surface_tension",
              [&](Keys& keys) { o.surface_tension = keys.number("tension", Range::at_least(0)); });
  read_effect(fluid, "volume_control", [&](Keys& keys) {
    VolumeControlOptions v;
    v.relaxation = keys.number("relaxation", Range::above(2), v.relaxation);
    v.damping = keys.number("damping", Range::above(0), v.damping);
    v.most_shift = keys.number("most_shift", Range{0, 1, true}, v.most_shift);
    v.most_integral = keys.number("most_integral", Range::between(0, 1), v.most_integral);
    o.volume_control = v;
  });
}

}  // namespace

std::shared_ptr<const FluidOptions> read_fluid(TomlTable& scene, const TrackerOptions& tracker,
                                               const std::filesystem::path& folder,
                                               const SceneSources& sources,
                                               std::vector<std::string>& notes) {
  const auto at = scene.tables.find("fluid");
  const auto solids = scene.lists.find("solids");
  if (at == scene.tables.end()) {
    if (solids != scene.lists.end())
      solids->second.front().keys.refuse("kind",
                                         "makes a solid, which only a scene with a table "
                                         "[fluid] can have");
    return nullptr;
  }
  TomlTable& fluid = at->second;
  Keys& keys = fluid.keys;
  FluidOptions o;
  o.cell_size = keys.number("cell_size", Range::above(0), tracker.cell_size);
  o.origin = keys.vector("origin", o.origin);
  o.density = keys.number("density", Range::above(0), o.density);
  o.gravity = keys.vector("gravity", o.gravity);
  o.cfl = keys.number("cfl", Range::above(0), o.cfl);
  o.most_steps = static_cast<int>(keys.integer("most_steps", Range::between(1, 1e6), o.most_steps));
  o.topology_cells = keys.number("topology_cells", Range::above(0).or_infinite(), o.topology_cells);
  o.advection = keys.choice("advection", kAdvections, o.advection);
  o.pressure = read_solver(keys, o.pressure);
  keys.done();
  read_effects(fluid, o);
  if (solids != scene.lists.end())
    for (TomlTable& solid : solids->second)
      o.solids.push_back(read_solid(solid, folder, sources, notes));
  return std::make_shared<const FluidOptions>(std::move(o));
}

}  // namespace suture::sims
