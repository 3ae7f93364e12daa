// The surfaces of cases, by name: closed oriented manifolds, most of them of 20 to 300 triangles.
#pragma once

#include <string>
#include <vector>

#include "kernel/random.h"
#include "kernel/triangles.h"

namespace suture::sims {

/// What a generator may draw on. Surfaces are about one unit across.
struct Draw {
  Random& random;
  double cell;  ///< of the lattice that is to come, in the same unit
  bool large;   ///< a few cases are ten times finer
};

/// All generators, in alphabetical order.
std::vector<std::string> generator_names();

/// A surface by the generator of that name. \throw InvalidInput for a name that is not known
Triangles generate(const std::string& name, Draw draw);

}  // namespace suture::sims
