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
void read_effects(TomlTable& fluid, FluidOptions& options) {
  std::vector<std::string> names;
  for (const EffectTable& effect : effect_tables()) names.push_back(effect.name);
  fluid.allow_tables(names);
  for (const EffectTable& effect : effect_tables())
    if (const auto at = fluid.tables.find(effect.name); at != fluid.tables.end()) {
      at->second.allow_tables({});
      effect.read(at->second.keys, options);
      at->second.keys.done();
    }
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
