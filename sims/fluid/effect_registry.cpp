// All effects that there are, and which of them a scene names.
#include "sims/fluid/effect_registry.h"

#include <utility>

#include "sims/fluid/effects/surface_tension.h"
#include "sims/fluid/effects/viscosity.h"
#include "sims/fluid/options_table.h"

namespace suture::sims {
namespace {

using Made = std::unique_ptr<Effect>;

Made viscosity(const FluidOptions& o, const ModuleAccount& account) {
  if (!o.viscosity) return nullptr;
  return make_viscosity({*o.viscosity, o.density, o.no_slip}, o.viscous_solver, account);
}

/// Shares the viscous solver's options with viscosity; `no_slip` is its own.
Made viscoelasticity(const FluidOptions& o, const ModuleAccount& account) {
  if (!o.viscoelasticity) return nullptr;
  ElasticOptions elastic = *o.viscoelasticity;
  elastic.density = o.density;
  return make_viscoelasticity(elastic, o.viscous_solver, account);
}

Made surface_tension(const FluidOptions& o, const ModuleAccount& account) {
  if (!o.surface_tension) return nullptr;
  return make_surface_tension({*o.surface_tension, o.density, o.cell_size}, account);
}

Made volume_control(const FluidOptions& o, const ModuleAccount& account) {
  if (!o.volume_control) return nullptr;
  return make_volume_control(*o.volume_control, account);
}

}  // namespace

const std::array<EffectMaker, 4>& effect_makers() {
  static constexpr std::array<EffectMaker, 4> kMakers{{
      {"viscosity", viscosity},
      {"viscoelasticity", viscoelasticity},
      {"surface_tension", surface_tension},
      {"volume_control", volume_control},
  }};
  return kMakers;
}

std::vector<std::unique_ptr<Effect>> make_effects(const FluidOptions& options, ModuleCosts& costs) {
  check(options);
  std::vector<std::unique_ptr<Effect>> effects;
  for (const EffectMaker& maker : effect_makers())
    if (Made effect = maker.make(options, {costs, maker.name}))
      effects.push_back(std::move(effect));
  return effects;
}

}  // namespace suture::sims
