// The motions by name, with their parameters and the ranges these may have.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sims/flows/motion.h"
#include "sims/support/keys.h"

namespace suture::sims {

/// The names that make_motion knows, in alphabetical order.
std::vector<std::string> motion_names();

/// Describes the parameters of the motion called `kind`; an unknown one has none.
std::vector<OptionInfo> motion_parameters(const std::string& kind);

/// The motion called `kind`, with its parameters read from `keys`, which may hold nothing else.
/// `velocities` are the bodies' own, one for each vertex; only the motion `bodies` uses them.
/// \throw InvalidInput for an unknown name or parameter, a wrong type, a value out of range
std::unique_ptr<Motion> make_motion(const std::string& kind, Keys& keys,
                                    const std::vector<Point>& velocities);

}  // namespace suture::sims
