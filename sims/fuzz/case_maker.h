// A seed becomes a case: the same case on every machine.
#pragma once

#include <optional>

#include "sims/fuzz/fuzz_case.h"
#include "sims/fuzz/generators.h"
#include "sims/fuzz/option_draws.h"

namespace suture::sims {

/// A campaign asks this of its cases. The seed decides whatever is not given.
struct CaseOptions {
  Profile profile = Profile::all;
  Arithmetic arithmetic = Arithmetic::filtered;
  std::optional<Collapse> collapse{};
  std::optional<double> jitter{};
};

/// All that cases are made of. A part more changes only those cases that come to have it.
struct CaseParts {
  std::vector<Generator> generators;
  std::vector<std::string> motions;
  std::vector<OptionDraw> options;
};

/// Every generator, every motion, and every option that is drawn.
const CaseParts& case_parts();

FuzzCase make_case(std::uint64_t seed, const CaseOptions& options,
                   const CaseParts& parts = case_parts());

}  // namespace suture::sims
