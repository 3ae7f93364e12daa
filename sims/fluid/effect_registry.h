// All effects that there are, and which of them a scene names.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "sims/fluid/effects/effect.h"
#include "sims/fluid/fluid_options.h"

namespace suture::sims {

/// An effect's name, which is that of its table in a scene and of its costs, and how it is made.
struct EffectMaker {
  const char* name;
  /// Null if the scene does not name it. \throw InvalidInput as the effect's own maker
  std::unique_ptr<Effect> (*make)(const FluidOptions& options, const ModuleAccount& account);
};

/// All effects, in the order in which they act. To add one, write its files in effects/, give its
/// options a place in FluidOptions, and add a line here and one in effect_tables.
const std::array<EffectMaker, 4>& effect_makers();

/// The effects that the scene names. They refer to `costs`. \throw InvalidInput unless all options
/// are in the ranges of their tables
std::vector<std::unique_ptr<Effect>> make_effects(const FluidOptions& options, ModuleCosts& costs);

}  // namespace suture::sims
