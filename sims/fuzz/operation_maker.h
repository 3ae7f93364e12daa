// The operations of a case: all motions with drawn parameters, displacements, improvements.
#pragma once

#include "kernel/random.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/perturbation.h"

namespace suture::sims {

/// Lengths that a case's operations follow.
struct OperationSizes {
  double unit = 1;  ///< about the size of the surface
  Point centre = Point::Zero();
  double cell = 0;
};

std::vector<Operation> make_operations(Profile profile, const OperationSizes& sizes,
                                       Random& random);

/// A displacement as an operation, and back. \throw InvalidInput if `values` do not make one
Operation displacement(const Spoiling& spoiling);
Spoiling spoiling_of(const Operation& operation);

}  // namespace suture::sims
