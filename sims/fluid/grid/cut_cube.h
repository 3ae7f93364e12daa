// The part of a cube on one side of a plane: how much of a cell is liquid.
#pragma once

#include "kernel/triangles.h"

namespace suture::sims {

/// The part of the unit cube about the origin where normal·x < s.
struct CutCube {
  double volume = 0;  ///< 0 to 1
  double offset = 0;  ///< of its centre of mass along the normal; 0 where the volume is 0
};

/// Volume to rounding [Scardovelli and Zaleski 2000, §2.1], offset to 1e-4.
/// \pre the normal's length is 1
CutCube cut_cube(const Point& normal, double s);

/// Its volume alone, at a 17th of the price. \pre the normal is not 0; it may have any length
double cut_volume(const Point& normal, double s);

}  // namespace suture::sims
