// The operations of a case: motions with drawn parameters, displacements, improvements, remodels.
#pragma once

#include "sims/fuzz/draws.h"
#include "sims/fuzz/fuzz_case.h"

namespace suture::sims {

/// Lengths that a case's operations follow.
struct OperationSizes {
  double unit = 1;  ///< about the size of the surface
  Point centre = Point::Zero();
  double cell = 0;
};

/// The source of a case's operations.
struct OperationDraws {
  Draws draws;
  const std::vector<std::string>& motions;  ///< a name not known here has no parameters
};

/// Operations that suit the profile, which is not `all`.
std::vector<Operation> make_operations(Profile profile, const OperationSizes& sizes,
                                       const OperationDraws& from);

}  // namespace suture::sims
