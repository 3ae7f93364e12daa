// One case, run through the tracker watched by the chosen checks.
#pragma once

#include <functional>

#include "sims/fuzz/checks.h"
#include "sims/fuzz/fuzz_case.h"
#include "sims/fuzz/summary.h"

namespace suture::sims {

struct CaseRun {
  FuzzSummary counts;          ///< of this case alone; at most one failure
  std::size_t operations = 0;  ///< done, the failing one included
};

/// Called before each operation with the operation's index and the surface.
using CaseWatcher = std::function<void(std::size_t, const Triangles&)>;

/// Runs a case until its end, the first failure, or an operation that is refused as bad input or as
/// too costly for a fuzzer, which ends it early. Depends on nothing but its arguments.
CaseRun run_case(const FuzzCase& c, const CheckChoice& checks, const CaseWatcher& watcher = {});

}  // namespace suture::sims
