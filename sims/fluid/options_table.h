// The tables of the fluid's options: who adds an option adds a field to its struct and a row here.
#pragma once

#include "kernel/option_table.h"
#include "sims/fluid/fluid_options.h"
#include "sims/support/keys.h"

namespace suture::sims {

/// [fluid] itself, and those tables inside it whose options stand in FluidOptions.
const OptionTable<FluidOptions>& fluid_options();
const OptionTable<FluidOptions>& viscosity_options();
const OptionTable<FluidOptions>& surface_tension_options();

/// A table inside [fluid], whose presence in a scene makes the effect of the same name.
struct EffectTable {
  std::string name;
  std::string meaning;              ///< a sentence for the reference of scene keys
  std::vector<OptionInfo> options;  ///< its keys
  void (*read)(Keys& keys, FluidOptions& options);
};

/// The tables of all effects, in the order in which the effects act. Each row is the only place
/// outside the effect's own files and FluidOptions that knows how a scene names its options.
const std::vector<EffectTable>& effect_tables();

/// [[solids]]: the kind of each, what says where one of that kind is, and how it moves.
const OptionTable<SolidOptions>& solid_options();
const OptionTable<SolidOptions>& box_solid_options();
const OptionTable<SolidOptions>& ball_solid_options();
const OptionTable<SolidMotion>& solid_motion_options();

/// \throw InvalidInput unless all options are in range
void check(const FluidOptions& options);

}  // namespace suture::sims
