// A campaign runs a range of seeds by forked workers, so that crashes and hangs are only results.
#pragma once

#include <functional>

#include "sims/fuzz/summary.h"

namespace suture::sims {

struct CampaignOptions {
  std::uint64_t first = 1;   ///< seed
  std::uint64_t cases = 0;   ///< 0: until the time is up
  double seconds = 0;        ///< no case is started after so long; 0: no limit
  int jobs = 1;              ///< workers at a time; the counts and the digest do not depend on it
  double case_seconds = 20;  ///< of a core; a case that takes longer hangs
};

/// Runs the case of a seed. It is called in a worker, so it may crash or never return.
using CaseRunner = std::function<FuzzSummary(std::uint64_t seed)>;

/// Hears the counts so far and the seconds since the start, some ten times a second.
using CampaignWatcher = std::function<void(const FuzzSummary&, double seconds)>;

/// Runs the seeds from `first` on. A worker that dies or exceeds case_seconds is a failure of the
/// seed it was at ("crash", "hang"); the rest goes on. The summary's settings are left empty.
/// \throw InvalidInput if neither cases nor seconds are given, or a number is out of range
FuzzSummary run_campaign(const CampaignOptions& options, const CaseRunner& run,
                         const CampaignWatcher& watcher = {});

}  // namespace suture::sims
