// Perturbations put vertices onto the lattice's planes, lines and nodes, or move them by a bit.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/triangles.h"
#include "sims/support/keys.h"

namespace suture::sims {

/// The kinds of perturbations.
enum class Perturb {
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

inline constexpr std::array<Named<Perturb>, 10> kPerturbNames = {{{"noise", Perturb::noise},
                                                                  {"snap", Perturb::snap},
                                                                  {"halve", Perturb::halve},
                                                                  {"nudge", Perturb::nudge},
                                                                  {"ulp", Perturb::ulp},
                                                                  {"flatten", Perturb::flatten},
                                                                  {"weld", Perturb::weld},
                                                                  {"shear", Perturb::shear},
                                                                  {"translate", Perturb::translate},
                                                                  {"scale", Perturb::scale}}};

struct Perturbation {
  Perturb how = Perturb::noise;
  double amount = 0.3;  ///< in cells, or a factor
  double share = 1;     ///< of the coordinates (weld: of the vertices) that are touched
  std::uint64_t seed = 0;
};

/// The lattice's planes, without end: origin + i · cell, rounded once.
struct LatticePlanes {
  double cell = 1;
  Point origin = Point::Zero();

  double nearest(double x, int axis) const;
};

/// \pre the planes' cell is finite and above zero
void perturb(std::vector<Point>& positions, const Perturbation& perturbation,
             const LatticePlanes& planes);

}  // namespace suture::sims
