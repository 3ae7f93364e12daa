// The tables [fluid] and [[solids]] of a scene.
#include "sims/fluid/fluid_reader.h"

#include <limits>

#include "sims/bodies_reader.h"

namespace suture {
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

SolverOptions read_solver(Keys& keys, const std::string& of, SolverOptions o) {
  o.tolerance = keys.number(of + "tolerance", Range{0, 1, true}, o.tolerance);
  o.most_iterations = static_cast<int>(
      keys.integer(of + "most_iterations", Range::between(1, 1e6), o.most_iterations));
  return o;
}

}  // namespace

std::optional<FluidOptions> read_fluid(TomlTable& scene, const TrackerOptions& tracker,
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
    return std::nullopt;
  }
  TomlTable& fluid = at->second;
  fluid.allow_tables({});
  Keys& keys = fluid.keys;
  FluidOptions o;
  o.cell_size = keys.number("cell_size", Range::above(0), tracker.cell_size);
  o.origin = keys.vector("origin", o.origin);
  o.density = keys.number("density", Range::above(0), o.density);
  o.gravity = keys.vector("gravity", o.gravity);
  o.cfl = keys.number("cfl", Range::above(0), o.cfl);
  o.most_steps = static_cast<int>(keys.integer("most_steps", Range::between(1, 1e6), o.most_steps));
  o.advection = keys.choice("advection", kAdvections, o.advection);
  o.pressure = read_solver(keys, "", o.pressure);
  keys.done();
  if (solids != scene.lists.end())
    for (TomlTable& solid : solids->second)
      o.solids.push_back(read_solid(solid, folder, sources, notes));
  return o;
}

}  // namespace suture
