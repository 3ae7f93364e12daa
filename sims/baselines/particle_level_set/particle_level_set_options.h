// The particle level set's options.
#pragma once

#include <cstdint>

#include "kernel/option_table.h"

namespace suture::sims {

/// The two publications differ in how φ moves and how it becomes a distance again.
enum class ParticleLevelSetVersion {
  semi_lagrangian,  ///< first-order semi-Lagrangian, first-order fast marching [Enright et al.
                    ///< 2005]
  weno              ///< fifth-order WENO and third-order TVD Runge–Kutta for both [2002]
};

/// Defaults are the published constants. Lengths called cells are in units of the cell's edge.
struct ParticleLevelSetOptions {
  double cell_size = 0;          ///< edge of a grid cell, in the scene's unit; must be set
  Point origin = Point::Zero();  ///< a node of the grid, so that the grid stays put in space
  ParticleLevelSetVersion version = ParticleLevelSetVersion::semi_lagrangian;
  int trace_order =
      2;  ///< semi_lagrangian: Runge–Kutta order, 2 to 4, of paths back [2005: second]
  int particle_order = 2;        ///< of the particles' paths [2005: second; 2002: third]
  int particles_per_cell = 64;   ///< of both signs, as PhysBAM counts [2002, §3.1]; 0: φ alone
  double band = 3;               ///< cells to each side of the surface that hold particles [§3.1]
  double smallest_radius = 0.1;  ///< cells [§3.1]
  double largest_radius = 0.5;   ///< cells [§3.1]
  double escape = 1;          ///< radii on the wrong side from which a particle has escaped [§3.3]
  int attraction_steps = 15;  ///< halvings of a step until a seed is given up [§3.1]
  int reinitialise_every = 1;  ///< steps; 0: never [2002 and 2005: each step]
  int reseed_every = 20;       ///< steps; 0: never [2002, §3.5]
  int relaxation_steps = 3;    ///< weno: of one re-initialisation, each a cell long [OpenVDB's]
  std::uint64_t seed = 1;      ///< of the random places and levels of the particles
};

/// Their table: who adds an option adds a field and a row.
const OptionTable<ParticleLevelSetOptions>& particle_level_set_options();

}  // namespace suture::sims
