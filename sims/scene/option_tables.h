// The tables of what a scene says of its bodies, of time, of what is written and what is measured.
#pragma once

#include "kernel/option_table.h"
#include "sims/scene/bodies_reader.h"
#include "sims/scene/scene.h"

namespace suture::sims {

const OptionTable<Scene>& scene_options();
const OptionTable<TimeOptions>& time_options();
const OptionTable<OutputOptions>& mesh_options();
const OptionTable<OutputOptions>& picture_options();
const OptionTable<MeasureOptions>& measure_options();

/// [[motion]]: its kind and when the next one takes over. Each kind has options of its own.
const OptionTable<Phase>& phase_options();

/// [[bodies]]: where a surface comes from and is placed, and how often it is there. A solid of the
/// kind `mesh` has the first as well.
const OptionTable<PlacedOptions>& placed_options();
const OptionTable<BodyOptions>& body_options();

}  // namespace suture::sims
