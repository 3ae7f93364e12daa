#include "sims/fluid/effect_registry.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <string>

#include "kernel/errors.h"
#include "sims/fluid/fluid.h"
#include "sims/fluid/options_table.h"
#include "tests/sims/fluid/watched.h"

using namespace suture;
using namespace suture::sims;

namespace {

/// A scene that names every effect.
FluidOptions all_effects() {
  FluidOptions o = tank();
  o.viscosity = 0.1;
  o.viscoelasticity = ElasticOptions{.modulus = 1};
  o.surface_tension = 0.07;
  o.volume_control.emplace();
  return o;
}

}  // namespace

TEST_CASE("an effect is made where the scene names it, and nowhere else") {
  ModuleCosts costs;
  CHECK(make_effects(tank(), costs).empty());
  CHECK(make_effects(all_effects(), costs).size() == effect_makers().size());
  FluidOptions one = tank();
  one.surface_tension = 0.07;
  REQUIRE(make_effects(one, costs).size() == 1);
  CHECK(std::isfinite(make_effects(one, costs)[0]->longest_step()));
}

TEST_CASE("every effect has a table in scenes, by the same name and in the same order") {
  REQUIRE(effect_tables().size() == effect_makers().size());
  for (std::size_t i = 0; i < effect_makers().size(); ++i) {
    CHECK(effect_tables()[i].name == effect_makers()[i].name);
    CHECK_FALSE(effect_tables()[i].options.empty());
  }
}

TEST_CASE("each effect counts its costs under the name of its table") {
  Watched run(column(), all_effects());
  run.run(1, 0.02);
  std::set<std::string> names;
  for (const ModuleCost& cost : run.fluid.costs()) names.insert(cost.name);
  for (const EffectMaker& maker : effect_makers()) {
    CAPTURE(maker.name);
    CHECK(names.count(maker.name) == 1);
  }
}

TEST_CASE("an effect's options out of range are refused, also beside others that are right") {
  const auto refused = [](auto change, const char* what) {
    FluidOptions o = all_effects();
    change(o);
    ModuleCosts costs;
    CHECK_THROWS_WITH(make_effects(o, costs), Catch::Contains(what));
  };
  refused([](FluidOptions& o) { o.viscosity = -1; }, "viscosity");
  refused([](FluidOptions& o) { o.viscoelasticity->modulus = -1; }, "modulus");
  refused([](FluidOptions& o) { o.viscoelasticity->yield_strain = 0; }, "yield_strain");
  refused([](FluidOptions& o) { o.viscoelasticity->flow_rate = -1; }, "flow_rate");
  refused([](FluidOptions& o) { o.surface_tension = -1; }, "tension");
  refused([](FluidOptions& o) { o.volume_control->damping = 0; }, "damping");
}

TEST_CASE("what several effects ask of the projection is added up") {
  ProjectionTerms terms;
  terms.add_divergence({1, 2});
  terms.add_divergence({0.5, -3});
  CHECK((terms.divergence == std::vector<double>{1.5, -1}));
  terms.add_jump({{{1}, {2}, {3}}});
  terms.add_jump({{{1}, {1}, {1}}});
  CHECK((terms.jump == std::array<std::vector<double>, 3>{{{2}, {3}, {4}}}));
}
