// Ways to throw vertices about: onto the lattice's planes, lines and nodes, or by a bit.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/triangles.h"
#include "sims/support/keys.h"

namespace suture::sims {

/// What becomes of vertices.
enum class Spoil {
  noise,      ///< every coordinate is moved by up to `amount` cells
  snap,       ///< coordinates go onto the nearest plane
  halve,      ///< coordinates go onto the nearest half of a cell
  nudge,      ///< coordinates go to a double next to the nearest plane
  ulp,        ///< coordinates go to a neighbouring double
  flatten,    ///< all of one axis go onto one plane
  weld,       ///< vertices take the place of another vertex: zero-length edges, collinear triangles
  shear,      ///< x by `amount` times z
  translate,  ///< all by one vector of up to `amount` cells
  scale       ///< all by `amount`, about the lattice's origin
};

inline constexpr std::array<Named<Spoil>, 10> kSpoilNames = {{{"noise", Spoil::noise},
                                                              {"snap", Spoil::snap},
                                                              {"halve", Spoil::halve},
                                                              {"nudge", Spoil::nudge},
                                                              {"ulp", Spoil::ulp},
                                                              {"flatten", Spoil::flatten},
                                                              {"weld", Spoil::weld},
                                                              {"shear", Spoil::shear},
                                                              {"translate", Spoil::translate},
                                                              {"scale", Spoil::scale}}};

struct Spoiling {
  Spoil how = Spoil::noise;
  double amount = 0.3;  ///< in cells, or a factor
  double share = 1;     ///< of the coordinates (weld: of the vertices) that are touched
  std::uint64_t seed = 0;
};

/// \pre cell is finite and above zero
void spoil(std::vector<Point>& positions, const Spoiling& spoiling, double cell,
           const Point& origin);

}  // namespace suture::sims
