// The particle level set's options: meaning, unit, range and source of each.
#include "sims/baselines/particle_level_set/particle_level_set_options.h"

#include "sims/baselines/grid/lattice_options.h"

namespace suture::sims {
namespace {

constexpr std::array<Named<ParticleLevelSetVersion>, 2> kVersions = {
    {{"semi_lagrangian", ParticleLevelSetVersion::semi_lagrangian},
     {"weno", ParticleLevelSetVersion::weno}}};

constexpr Unit kRadii{"radii"};

using P = ParticleLevelSetOptions;
const OptionTable<P> kParticleLevelSet(
    "method",
    {{"cell_size", &P::cell_size, kCellSize},
     {"origin", &P::origin, kOrigin},
     {"version",
      {&P::version, kVersions},
      {.meaning = "the publication that is followed: how the level set moves and becomes a "
                  "distance again",
       .source = "Enright et al. 2005; 2002"}},
     {"trace_order", &P::trace_order, kTraceOrder},
     {"particle_order",
      &P::particle_order,
      {.meaning = "order of the Runge–Kutta method for particles", .range = Range::between(2, 4)}},
     {"particles_per_cell",
      &P::particles_per_cell,
      {.meaning = "particles of both signs in a cell near the surface; 0: none",
       .range = Range::between(0, 4096),
       .source = "Enright et al. 2002, §3.1"}},
     {"band",
      &P::band,
      {.meaning = "cells to each side of the surface that hold particles",
       .unit = unit::cells,
       .range = Range::between(1, 100),
       .source = "Enright et al. 2002, §3.1"}},
     {"smallest_radius",
      &P::smallest_radius,
      {.meaning = "least radius of a particle",
       .unit = unit::cells,
       .range = Range::above(0),
       .source = "Enright et al. 2002, §3.1"}},
     {"largest_radius",
      &P::largest_radius,
      {.meaning = "largest radius of a particle, at most the band",
       .unit = unit::cells,
       .range = Range::above(0),
       .source = "Enright et al. 2002, §3.1"}},
     {"escape",
      &P::escape,
      {.meaning = "how far on the wrong side a particle has escaped",
       .unit = kRadii,
       .range = Range::at_least(0),
       .source = "Enright et al. 2002, §3.3"}},
     {"attraction_steps",
      &P::attraction_steps,
      {.meaning = "halvings of a step until a seed is given up",
       .unit = unit::steps,
       .range = Range::at_least(0),
       .source = "Enright et al. 2002, §3.1"}},
     {"reinitialise_every",
      &P::reinitialise_every,
      {.meaning = "steps between re-initialisations; 0: never",
       .unit = unit::steps,
       .range = Range::at_least(0),
       .source = "Enright et al. 2002"}},
     {"reseed_every",
      &P::reseed_every,
      {.meaning = "steps between seedings of particles; 0: never",
       .unit = unit::steps,
       .range = Range::at_least(0),
       .source = "Enright et al. 2002, §3.5"}},
     {"relaxation_steps",
      &P::relaxation_steps,
      {.meaning = "with version = weno only: steps of one re-initialisation, each a cell long",
       .unit = unit::steps,
       .range = Range::between(1, 1000)}},
     {"seed",
      &P::seed,
      {.meaning = "seed of the random places and levels of the particles",
       .range = Range::at_least(0)}}});

}  // namespace

const OptionTable<ParticleLevelSetOptions>& particle_level_set_options() {
  return kParticleLevelSet;
}

}  // namespace suture::sims
