// Semi-Lagrangian contouring's options.
#pragma once

#include "kernel/option_table.h"

namespace suture::sims {

/// [Strain 2001; Bargteil, Goktekin, O'Brien and Strain 2006], on a uniform lattice near the
/// surface in place of their octrees, and with exact distances and signs where they interpolate far
/// away.
struct ContouringOptions {
  double cell_size = 0;          ///< edge of the cubes that are contoured; must be set
  Point origin = Point::Zero();  ///< a node of the lattice
  int trace_order = 2;           ///< of the Runge–Kutta method for paths, 2 to 4; published is 2
  /// Evaluations of the exact function along a lattice edge that find a vertex, by the Illinois
  /// variant of regula falsi; 0: vertices are where a linear function is zero.
  int refinements = 5;
};

/// Their table: who adds an option adds a field and a row.
const OptionTable<ContouringOptions>& contouring_options();

}  // namespace suture::sims
