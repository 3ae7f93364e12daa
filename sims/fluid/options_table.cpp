// The tables of the fluid's options: meaning, unit, range and source of each.
#include "sims/fluid/options_table.h"

namespace suture::sims {
namespace {

constexpr std::array<Named<VelocityAdvection>, 2> kAdvections = {
    {{"semi_lagrangian", VelocityAdvection::semi_lagrangian},
     {"mac_cormack", VelocityAdvection::mac_cormack}}};
constexpr std::array<Named<SolidKind>, 4> kSolids = {{{"container", SolidKind::container},
                                                      {"box", SolidKind::box},
                                                      {"ball", SolidKind::ball},
                                                      {"mesh", SolidKind::mesh}}};

const OptionInfo kTolerance{
    .meaning = "the residual that a solve may leave, as a part of the right side's size",
    .range = Range{0, 1, true}};
const OptionInfo kMostIterations{.meaning = "iterations after which a solve ends all the same",
                                 .range = Range::between(1, 1e6)};
const OptionInfo kNoSlip{.meaning = "viscous liquid sticks to solids; else they only push"};

using F = FluidOptions;
const OptionTable<F> kFluid(
    "fluid",
    {{"cell_size",
      &F::cell_size,
      {.meaning = "edge of a cell of the physics grid",
       .unit = unit::length,
       .range = Range::above(0),
       .otherwise = "that of [tracker]"}},
     {"origin", &F::origin, {.meaning = "a corner of the physics grid", .unit = unit::length}},
     {"density",
      &F::density,
      {.meaning = "density of the liquid", .unit = unit::density, .range = Range::above(0)}},
     {"gravity", &F::gravity, {.meaning = "acceleration of gravity", .unit = unit::acceleration}},
     {"cfl",
      &F::cfl,
      {.meaning = "cells that the fastest liquid or solid may cross in a step of the fluid",
       .unit = unit::cells,
       .range = Range::above(0)}},
     {"most_steps",
      &F::most_steps,
      {.meaning = "steps of a frame; what would take more is run with a larger CFL number",
       .unit = unit::steps,
       .range = Range::between(1, 1e6)}},
     {"topology_cells",
      &F::topology_cells,
      {.meaning = "topology is also handled within a frame, once the fastest liquid may have "
                  "crossed so many cells since it last was; inf: at the end of frames only",
       .unit = unit::cells,
       .range = Range::above(0).or_infinite(),
       .source = "§7"}},
     {"advection",
      {&F::advection, kAdvections},
      {.meaning = "what moves the velocity", .source = "Stam 1999; Selle et al. 2008"}},
     {"tolerance", inside(&F::pressure, &SolverOptions::tolerance), kTolerance},
     {"most_iterations", inside(&F::pressure, &SolverOptions::most_iterations), kMostIterations}});

const OptionTable<F> kViscosity(
    "fluid.viscosity",
    {{"viscosity",
      &F::viscosity,
      {.meaning = "dynamic viscosity",
       .unit = unit::viscosity,
       .range = Range::at_least(0),
       .required = true,
       .source = "Batty and Bridson 2008"}},
     {"no_slip", &F::no_slip, kNoSlip},
     {"tolerance", inside(&F::viscous_solver, &SolverOptions::tolerance), kTolerance},
     {"most_iterations", inside(&F::viscous_solver, &SolverOptions::most_iterations),
      kMostIterations}});

const OptionTable<F> kSurfaceTension("fluid.surface_tension",
                                     {{"tension",
                                       &F::surface_tension,
                                       {.meaning = "surface tension",
                                        .unit = unit::tension,
                                        .range = Range::at_least(0),
                                        .required = true,
                                        .source = "Wojtan and Turk 2008"}}});

using S = SolidOptions;
const OptionTable<S> kSolid("solids", {{"kind",
                                        {&S::kind, kSolids},
                                        {.meaning = "the solid's shape; a container's inside "
                                                    "is free and all else is solid"}}});
const OptionTable<S> kBoxSolid(
    "solids",
    {{"low", inside(&S::box, &Box::low), {.meaning = "corner of the box", .unit = unit::length}},
     {"high",
      inside(&S::box, &Box::high),
      {.meaning = "the corner across, each number above that of low", .unit = unit::length}}});
const OptionTable<S> kBallSolid(
    "solids", {{"centre", &S::centre, {.meaning = "centre of the ball", .unit = unit::length}},
               {"radius",
                &S::radius,
                {.meaning = "radius of the ball",
                 .unit = unit::length,
                 .range = Range::above(0),
                 .required = true}}});

using M = SolidMotion;
const OptionTable<M> kSolidMotion(
    "solids",
    {{"velocity", &M::velocity, {.meaning = "velocity of the solid", .unit = unit::speed}},
     {"amplitude",
      &M::amplitude,
      {.meaning = "how far the solid swings besides, as a sine", .unit = unit::length}},
     {"period",
      &M::period,
      {.meaning = "period of the swing", .unit = unit::time, .range = Range::above(0)}}});

}  // namespace

const OptionTable<F>& fluid_options() { return kFluid; }
const OptionTable<F>& viscosity_options() { return kViscosity; }
const OptionTable<F>& surface_tension_options() { return kSurfaceTension; }
const OptionTable<S>& solid_options() { return kSolid; }
const OptionTable<S>& box_solid_options() { return kBoxSolid; }
const OptionTable<S>& ball_solid_options() { return kBallSolid; }
const OptionTable<M>& solid_motion_options() { return kSolidMotion; }

const std::vector<EffectTable>& effect_tables() {
  static const std::vector<EffectTable> tables{
      {"viscosity", "The liquid is viscous.", infos(kViscosity),
       [](Keys& keys, F& o) { read(keys, kViscosity, o); }},
      {"viscoelasticity", "The liquid is elastic.", infos(viscoelasticity_options()),
       [](Keys& keys, F& o) {
         o.viscoelasticity.emplace().no_slip = o.no_slip;  // viscosity's, unless it has its own
         read(keys, viscoelasticity_options(), *o.viscoelasticity);
       }},
      {"surface_tension", "The liquid has surface tension.", infos(kSurfaceTension),
       [](Keys& keys, F& o) { read(keys, kSurfaceTension, o); }},
      {"volume_control", "Lost volume of the liquid comes back.", infos(volume_control_options()),
       [](Keys& keys, F& o) { read(keys, volume_control_options(), o.volume_control.emplace()); }}};
  return tables;
}

void check(const FluidOptions& options) {
  check(options, kFluid, "fluid: ");
  check(options, kViscosity, "fluid: ");
  check(options, kSurfaceTension, "fluid: ");
  if (options.viscoelasticity)
    check(*options.viscoelasticity, viscoelasticity_options(), "fluid: ");
  if (options.volume_control)
    check(*options.volume_control, volume_control_options(), "volume control: ");
}

}  // namespace suture::sims
