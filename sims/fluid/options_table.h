// The tables of the fluid's options: who adds an option adds a field to its struct and a row here.
#pragma once

#include "kernel/option_table.h"
#include "sims/fluid/fluid_options.h"

namespace suture::sims {

/// [fluid] itself, and the tables inside it, one an effect.
const OptionTable<FluidOptions>& fluid_options();
const OptionTable<FluidOptions>& viscosity_options();
const OptionTable<FluidOptions>& surface_tension_options();
const OptionTable<ElasticOptions>& viscoelasticity_options();
const OptionTable<VolumeControlOptions>& volume_control_options();

/// [[solids]]: the kind of each, what says where one of that kind is, and how it moves.
const OptionTable<SolidOptions>& solid_options();
const OptionTable<SolidOptions>& box_solid_options();
const OptionTable<SolidOptions>& ball_solid_options();
const OptionTable<SolidMotion>& solid_motion_options();

/// \throw InvalidInput unless all options are in range
void check(const FluidOptions& options);

}  // namespace suture::sims
