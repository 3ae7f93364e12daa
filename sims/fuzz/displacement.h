// A perturbation becomes an operation of a case, and the operation a perturbation again.
#pragma once

#include "sims/fuzz/fuzz_case.h"
#include "sims/fuzz/perturbation.h"

namespace suture::sims {

Operation displacement(const Perturbation& perturbation);

/// \throw InvalidInput if the operation's values do not make a perturbation
Perturbation perturbation_of(const Operation& operation);

}  // namespace suture::sims
