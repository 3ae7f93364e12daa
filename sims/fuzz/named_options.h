// A case's options by the names that their tables give them: "tracker.depth", "quality.passes".
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kernel/option.h"
#include "surgery/model/options.h"

namespace suture::sims {

/// Every option of the tracker's two tables, in their order.
std::vector<std::string> option_names();

/// The row of an option in its table. \throw InvalidInput for a name that is not known
const OptionInfo& option_named(const std::string& name);

/// \throw InvalidInput for a name that is not known, or a value that the option does not allow
void set_option(TrackerOptions& options, const std::string& name, const Value& value);

/// The values of all options, in the tables' order; equal for options that are written alike.
std::vector<std::pair<std::string, Value>> named_values(const TrackerOptions& options);

/// Multiplies every length among the options by 2^exponent.
void scale_lengths(TrackerOptions& options, int exponent);

}  // namespace suture::sims
