// Failures become minimal cases in a folder, each with its cause. Cases are tried in isolation.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "sims/fuzz/checks.h"
#include "sims/fuzz/fuzz_case.h"
#include "sims/fuzz/minimise.h"
#include "sims/fuzz/summary.h"

namespace suture::sims {

/// Runs the case in a child, for at most so many seconds of a core.
/// \return its counts and at most one failure, crashes and hangs included
FuzzSummary run_in_child(const FuzzCase& c, const CheckChoice& checks, double seconds);

/// The failure of run_in_child, if there is one.
std::optional<FuzzFailure> failure_of(const FuzzCase& c, const CheckChoice& checks, double seconds);

/// The folder for failing cases, the checks that found them, and the minimiser's limits.
struct CorpusOptions {
  std::filesystem::path folder;
  CheckChoice checks;
  MinimiseLimits limits;
};

/// Minimises and saves the summary's failing cases, at most limits.each of a kind, and writes the
/// files' names into it. \param case_of the case of a seed
/// \throw InvalidInput if a file cannot be written
void save_failures(FuzzSummary& summary, const std::function<FuzzCase(std::uint64_t)>& case_of,
                   const CorpusOptions& options);

}  // namespace suture::sims
