// The options of the fluid solver. An effect that a scene does not name does not exist.
#pragma once

#include <optional>
#include <vector>

#include "sims/fluid/effects/viscoelasticity.h"
#include "sims/fluid/effects/volume_control.h"
#include "sims/fluid/linear/linear_system.h"
#include "sims/fluid/solids/solid_options.h"
#include "sims/fluid/velocity/advect_velocity.h"

namespace suture::sims {

struct FluidOptions {
  double cell_size = 0;  ///< of the physics grid; the tracker's lattice and edges are set apart
  Point origin = Point::Zero();
  double density = 1000;
  Point gravity = Point::Zero();
  /// Cells that the fastest liquid or solid may cross in a step; frames are cut into steps,
  /// equal ones but for what the speed asks for meanwhile.
  double cfl = 2;
  /// The most steps of a frame; what would take more is run with a larger CFL number, and with no
  /// more surface tension than such steps hold stable (stable_part).
  int most_steps = 1000;
  /// Topology is handled at the end of frames [§7], and within one once the fastest liquid may have
  /// crossed so many cells since: between surgeries the surface is markers, which longer ways fold
  /// into sheets through one another, and these are lost. Infinite: at the end of frames only.
  double topology_cells = 8;
  VelocityAdvection advection = VelocityAdvection::mac_cormack;
  SolverOptions pressure;

  std::optional<double> viscosity;           ///< dynamic: force per area and rate of shear
  bool no_slip = true;                       ///< of viscous liquid at solids
  SolverOptions viscous_solver{1e-5, 1000};  ///< of viscosity and elasticity
  std::optional<ElasticOptions> viscoelasticity;
  std::optional<double> surface_tension;  ///< force per length
  std::optional<VolumeControlOptions> volume_control;
  std::vector<SolidOptions> solids;
};

}  // namespace suture::sims
