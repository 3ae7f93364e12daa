// Semi-Lagrangian contouring: each step a new mesh, where the old mesh's distance is zero upstream.
#pragma once

#include <memory>

#include "sims/tracking/surface_tracker.h"

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

/// Starts as the mesh itself. Steps may be longer than cells.
/// \throw InvalidInput if an option is out of range; advect throws it where u is not finite, or
/// carries the surface so unevenly in one step that no band of nodes holds it
std::unique_ptr<SurfaceTracker> make_semi_lagrangian_contouring(const Triangles& surface,
                                                                const ContouringOptions& options);

}  // namespace suture::sims
