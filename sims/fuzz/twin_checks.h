// Checks that remodel a twin of the surface before, and compare what comes out. Each objects to
// nothing where its promise does not apply.
#pragma once

#include "sims/fuzz/observation.h"

namespace suture::sims {

Objection check_rational(const Observation& o);
Objection check_scaling(const Observation& o);
Objection check_axes(const Observation& o);
Objection check_cells(const Observation& o);
Objection check_order(const Observation& o);

}  // namespace suture::sims
