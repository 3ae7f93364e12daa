// Remodels under an oracle that lies, as many as asked for: JSON on standard output.
// usage: lying_campaign [first seed [cases [jobs]]]
#include <fmt/core.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "sims/fuzz/campaign.h"
#include "tests/brute/lying_runs.h"

using namespace suture;
using namespace suture::surgery;
using namespace suture::sims;

namespace {

FuzzSummary counted(std::uint64_t seed) {
  FuzzSummary one;
  one.cases = 1;
  const auto fail = [&](const std::string& oracle, const std::string& cause) {
    one.failures.push_back({seed, oracle, cause, {}});
  };
  try {
    const LyingRun run = run_lying(seed);
    const auto count = [&](const char* what, int times) {
      one.operations[fmt::format("{} at {}", what, run.probability)] +=
          static_cast<std::uint64_t>(times);
    };
    count("committed", run.committed);
    count("refused", run.refused);
    count("unchanged", run.unchanged);
    count("improved", run.improved);
    one.surgeries = static_cast<std::uint64_t>(run.committed);
    one.remodels = static_cast<std::uint64_t>(run.committed + run.refused + run.unchanged);
    if (!run.fault.empty()) fail("junk", run.fault);
  } catch (const std::exception& error) {
    fail("exception", error.what());
  }
  return one;
}

}  // namespace

int main(int argc, char** argv) {
  CampaignOptions options{.first = 1, .cases = 10000};
  if (argc > 1) options.first = std::strtoull(argv[1], nullptr, 10);
  if (argc > 2) options.cases = std::strtoull(argv[2], nullptr, 10);
  if (argc > 3) options.jobs = std::atoi(argv[3]);
  const FuzzSummary sum = run_campaign(options, counted);
  nlohmann::json json = to_json(sum);
  for (const char* key :
       {"version", "profile", "arithmetic", "collapse", "oracles_asked", "jitter", "triangles",
        "largest_mesh", "digest", "refused", "ended_early", "generators"})
    json.erase(key);
  fmt::print("{}\n", json.dump(1));
  return sum.failures.empty() ? 0 : 1;
}
