// The choices of the level set baseline, with OpenVDB's defaults.
#pragma once

#include "kernel/triangles.h"

namespace suture::sims {

/// The differences that gradients are: from one side, to some order, or weighted so that they do
/// not oscillate [Jiang and Peng 2000]. OpenVDB's WENO5 for conservation laws is no scheme for φ:
/// it is left out.
enum class UpwindScheme { first, second, third, weno5 };

/// The scheme that moves φ.
enum class Advection {
  upwind,      ///< u·∇φ by the method of lines, in sub-steps of the library's own CFL number
  mac_cormack  ///< semi-Lagrangian, forth, back and corrected, one step whatever its length [Selle
               ///< et al. 2008]
};

/// The fate of a MacCormack correction that leaves the range of the values it comes from.
enum class Limiter {
  clamp,   ///< it is cut off there [Selle et al. 2008, §3.1]
  revert,  ///< there is none
  none     ///< it stays
};

/// Re-normalisation: φ is relaxed towards |∇φ| = 1 in pseudo-time [Sussman, Smereka and Osher 1994;
/// Peng et al. 1999].
struct Renormalisation {
  int every = 1;  ///< sub-steps (upwind) or steps (MacCormack); 0: never
  UpwindScheme scheme = UpwindScheme::weno5;
  int time_order = 1;  ///< of the TVD Runge–Kutta method, 1 to 3; the step is 0.3, 0.9 or 1 cell
  int steps = 3;       ///< each time
};

/// The defaults are OpenVDB's.
struct LevelSetOptions {
  double cell_size = 0;          ///< must be set
  Point origin = Point::Zero();  ///< a node of the lattice
  double half_width = 3;         ///< cells on either side of the surface that hold values
  Advection advection = Advection::upwind;
  UpwindScheme scheme = UpwindScheme::weno5;
  int time_order = 2;   ///< upwind: of the TVD Runge–Kutta method, 1 to 3
  int trace_order = 2;  ///< MacCormack: of the Runge–Kutta method for paths, 2 to 4
  Limiter limiter = Limiter::clamp;
  Renormalisation renormalise{};
};

}  // namespace suture::sims
