// The tables [fluid] and [[solids]] of a scene.
#include "sims/scene/fluid_reader.h"

#include "sims/fluid/options_table.h"
#include "sims/scene/bodies_reader.h"

namespace suture::sims {
namespace {

void require_box(const Keys& keys, const Box& box) {
  if (!(box.low.array() < box.high.array()).all())
    keys.refuse("low", "and high are a box's corners; give each of low below high");
}

SolidOptions read_solid(TomlTable& solid, const std::filesystem::path& folder,
                        const SceneSources& sources, std::vector<std::string>& notes) {
  solid.allow_tables({"parameters"});
  Keys& keys = solid.keys;
  SolidOptions s;
  read(keys, solid_options(), s);
  if (s.kind == SolidKind::mesh) {
    s.surface = read_placed(solid, folder, sources, notes).surface;
  } else if (s.kind == SolidKind::ball) {
    read(keys, ball_solid_options(), s);
  } else {
    read(keys, box_solid_options(), s);
    require_box(keys, s.box);
  }
  read(keys, solid_motion_options(), s.motion);
  keys.done();
  return s;
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
  read_effect(fluid, "viscosity", [&](Keys& keys) { read(keys, viscosity_options(), o); });
  read_effect(fluid, "viscoelasticity", [&](Keys& keys) {
    o.viscoelasticity.emplace().no_slip = o.no_slip;  // viscosity's, unless it has its own
    read(keys, viscoelasticity_options(), *o.viscoelasticity);
  });
  read_effect(fluid, "surface_tension",
              [&](Keys& keys) { read(keys, surface_tension_options(), o); });
  read_effect(fluid, "volume_control", [&](Keys& keys) {
    read(keys, volume_control_options(), o.volume_control.emplace());
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
  FluidOptions o;
  o.cell_size = tracker.cell_size;
  read(fluid.keys, fluid_options(), o);
  fluid.keys.done();
  read_effects(fluid, o);
  if (solids != scene.lists.end())
    for (TomlTable& solid : solids->second)
      o.solids.push_back(read_solid(solid, folder, sources, notes));
  return std::make_shared<const FluidOptions>(std::move(o));
}

}  // namespace suture::sims
