// The surfaces of cases, by name: closed oriented manifolds, most of them of 20 to 300 triangles.
#pragma once

#include <string>
#include <vector>

#include "kernel/triangles.h"
#include "sims/fuzz/draws.h"

namespace suture::sims {

enum class CaseSize {
  usual,
  large  ///< about ten times finer; a few cases are
};

/// A generator makes a surface of this and nothing else. Surfaces are about one unit across.
struct GeneratorInput {
  Draws draws;
  double cell;  ///< edge of the cells of the lattice that is to come, in the same unit
  CaseSize size = CaseSize::usual;

  bool large() const { return size == CaseSize::large; }
  GeneratorInput in(const char* part, int index = 0) const;  ///< with that part's own draws
};

struct Generator {
  std::string name;
  Triangles (*make)(const GeneratorInput&);
};

/// All generators, in alphabetical order.
const std::vector<Generator>& generators();

/// The generator of that name among `known`. \throw InvalidInput for a name that is not known
const Generator& generator_named(const std::string& name,
                                 const std::vector<Generator>& known = generators());

}  // namespace suture::sims
