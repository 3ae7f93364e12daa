// The level set's options: meaning, unit, range and source of each.
#include "sims/baselines/level_set/level_set_options.h"

#include "sims/baselines/grid/lattice_options.h"

namespace suture::sims {
namespace {

constexpr std::array<Named<Advection>, 2> kAdvections = {
    {{"upwind", Advection::upwind}, {"mac_cormack", Advection::mac_cormack}}};
constexpr std::array<Named<UpwindScheme>, 4> kSchemes = {{{"first", UpwindScheme::first},
                                                          {"second", UpwindScheme::second},
                                                          {"third", UpwindScheme::third},
                                                          {"weno5", UpwindScheme::weno5}}};
constexpr std::array<Named<Limiter>, 3> kLimiters = {
    {{"clamp", Limiter::clamp}, {"revert", Limiter::revert}, {"none", Limiter::none}}};

using L = LevelSetOptions;
const OptionTable<L> kLevelSet(
    "method",
    {{"cell_size", &L::cell_size, kCellSize},
     {"origin", &L::origin, kOrigin},
     {"half_width",
      &L::half_width,
      {.meaning = "cells on either side of the surface that hold values",
       .unit = unit::cells,
       .range = Range::between(1, 1000)}},
     {"advection",
      {&L::advection, kAdvections},
      {.meaning = "what moves the level set: upwind sub-steps, or one MacCormack step",
       .source = "Selle et al. 2008"}},
     {"scheme",
      {&L::scheme, kSchemes},
      {.meaning = "how upwind steps take gradients", .source = "Jiang and Peng 2000"}},
     {"time_order", &L::time_order, kTimeOrder},
     {"trace_order", &L::trace_order, kTraceOrder},
     {"limiter",
      {&L::limiter, kLimiters},
      {.meaning = "what becomes of a MacCormack correction that leaves the range of the values it "
                  "comes from",
       .source = "Selle et al. 2008, §3.1"}},
     {"renormalise_every",
      inside(&L::renormalise, &Renormalisation::every),
      {.meaning = "sub-steps (upwind) or steps (MacCormack) between re-normalisations; 0: never",
       .unit = unit::steps,
       .range = Range::at_least(0),
       .source = "Sussman, Smereka and Osher 1994"}},
     {"renormalise_scheme",
      {inside(&L::renormalise, &Renormalisation::scheme), kSchemes},
      {.meaning = "how re-normalisation takes gradients", .source = "Jiang and Peng 2000"}},
     {"renormalise_time_order",
      inside(&L::renormalise, &Renormalisation::time_order),
      {.meaning = "order of the TVD Runge–Kutta method in pseudo-time",
       .range = Range::between(1, 3),
       .source = "Shu and Osher 1988"}},
     {"renormalise_steps",
      inside(&L::renormalise, &Renormalisation::steps),
      {.meaning = "steps in pseudo-time of each re-normalisation",
       .unit = unit::steps,
       .range = Range::between(1, 1000)}}});

}  // namespace

const OptionTable<LevelSetOptions>& level_set_options() { return kLevelSet; }

}  // namespace suture::sims
